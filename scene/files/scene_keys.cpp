#include "scene/files/scene_keys.hpp"

#include <algorithm>
#include <cstdio>

#include "lighting/microfacet_choices.hpp"
#include "lighting/spectrum.hpp"

namespace kreda::scene {

namespace {

using enum KeyType;

constexpr Range kAny{};
constexpr Range kPlace{-kFarthest, kFarthest};  // read in double; what matters is the distance to the camera
constexpr Range kNotNegative{0.0, 1e9};
constexpr Range kPositive{1e-9, 1e9};
constexpr Range kShare{0.0, 1.0};
constexpr Range kIndex{0.1, 10.0};
constexpr Range kWardAlpha{0.002, 1.0};  // narrower than the least alpha of a microfacet: it would glitter

std::vector<std::string_view> measured_names() {
    std::vector<std::string_view> names;
    for (const lighting::MeasuredMaterial& material : lighting::measured_materials()) names.push_back(material.name);
    return names;
}

/// The words of a table of formulas (lighting/microfacet_choices.hpp), in the order of its enumeration.
template <std::size_t N>
std::vector<std::string_view> keys_of(const std::array<lighting::FormulaFacts, N>& formulas) {
    std::vector<std::string_view> keys;
    for (const lighting::FormulaFacts& formula : formulas) keys.push_back(formula.key);
    return keys;
}

std::vector<KeyInfo> make_keys() {
    return {
        {"image", "size", whole_pair, "[640, 360]", "width and height in pixels", {1, 16384}, {}, ""},
        {"image", "samples", whole, "1", "n x n supersampling", {1, 8}, {}, ""},
        {"image",
         "background",
         vector_or_word,
         "[0, 0, 0]",
         "linear RGB, or what surrounds the scene",
         kNotNegative,
         {"environment"},
         ""},
        {"image", "exposure", number, "1.0", "multiplies radiance before tone mapping", kNotNegative, {}, ""},
        {"image",
         "tone_map",
         word,
         "\"none\"",
         "radiance to 0..1; none: clamp",
         kAny,
         {"none", "reinhard", "reinhard_extended"},
         ""},
        {"image", "white", number, "4.0", "reinhard_extended: the radiance that maps to 1", kPositive, {}, ""},
        {"image",
         "transfer",
         word,
         "\"srgb\"",
         "linear values to the file's 8 bits",
         kAny,
         {"srgb", "gamma", "linear"},
         ""},
        {"image", "gamma", number, "2.2", "transfer = \"gamma\": the exponent", kPositive, {}, ""},

        {"camera", "position", vector, "[0, 1, 4]", "where the camera is", kPlace, {}, ""},
        {"camera", "target", vector, "[0, 0, 0]", "the point it looks at", kPlace, {}, ""},
        {"camera", "up", vector, "[0, 1, 0]", "what is up in the picture", kAny, {}, ""},
        {"camera",
         "projection",
         word,
         "\"perspective\"",
         "how depth becomes size",
         kAny,
         {"perspective", "orthographic"},
         ""},
        {"camera", "vertical_fov", number, "45", "perspective: degrees from bottom to top", {0, 180, true}, {}, ""},
        {"camera", "height", number, "2", "orthographic: world units from bottom to top", kPositive, {}, ""},
        {"camera", "near", number, "0.1", "distance of the near plane", kPositive, {}, ""},
        {"camera", "far", number, "100", "distance of the far plane, beyond near", kPositive, {}, ""},

        {"shading",
         "frequency",
         word,
         "\"phong\"",
         "light per triangle, per vertex or per pixel",
         kAny,
         {"flat", "gouraud", "phong"},
         ""},
        {"shading",
         "interpolation",
         word,
         "\"perspective\"",
         "affine shows why not",
         kAny,
         {"perspective", "affine"},
         ""},
        {"shading",
         "cull",
         word,
         "\"back\"",
         "which side of a triangle is not drawn",
         kAny,
         {"back", "front", "none"},
         ""},
        {"shading",
         "two_sided",
         boolean,
         "true",
         "where cull lets a back be seen: its normal is turned to the viewer; false takes the light of the front",
         kAny,
         {},
         ""},

        {"ambient", "color", vector, "[0.05, 0.05, 0.05]", "s_A: light from everywhere", kNotNegative, {}, ""},

        {"light",
         "type",
         word,
         "\"directional\"",
         "the sun, a lamp, or a lamp in a cone",
         kAny,
         {"directional", "point", "spot"},
         ""},
        {"light", "direction", vector, "[-1, -2, -1]", "directional, spot: the way the light travels", kAny, {}, ""},
        {"light", "position", vector, "[2, 3, 1]", "point, spot: where it is", kPlace, {}, ""},
        {"light", "color", vector, "[1, 1, 1]", "linear RGB", kNotNegative, {}, ""},
        {"light", "intensity", number, "1.0", "multiplies color", kNotNegative, {}, ""},
        {"light",
         "attenuation",
         vector_or_word,
         "[1, 0, 0]",
         "1 / (c + l d + q d^2); \"physical\": 1 / d^2",
         kNotNegative,
         {"physical"},
         ""},
        {"light",
         "cone",
         number_pair,
         "[20, 30]",
         "spot: half-angles in degrees; full light inside the first, none outside the second",
         {0, 180},
         {},
         ""},
        {"light", "shadow", boolean, "false", "whether it casts shadows", kAny, {}, ""},
        {"light", "on", boolean, "true", "false switches it off", kAny, {}, ""},

        {"shadow",
         "method",
         word,
         "\"map\"",
         "how shadows are found",
         kAny,
         {"map", "planar", "volume", "irregular", "exact"},
         ""},
        {"shadow", "size", whole, "1024", "map: texels a side", {1, 8192}, {}, ""},
        {"shadow",
         "filter",
         word,
         "\"none\"",
         "map: hard edges, blurred ones, or as soft as the light is wide",
         kAny,
         {"none", "pcf", "pcss"},
         ""},
        {"shadow", "radius", whole, "1", "pcf: mean of (2 radius + 1)^2 texels", {0, 64}, {}, ""},
        {"shadow",
         "light_size",
         number,
         "0.2",
         "pcss: the light's width; directional: seen from distance 1",
         kNotNegative,
         {},
         ""},
        {"shadow",
         "bias",
         word,
         "\"slope\"",
         "map: what keeps a surface from shadowing itself",
         kAny,
         {"none", "constant", "slope", "normal_offset"},
         ""},
        {"shadow", "constant_bias", number, "0.0005", "share of the map's range of depth", kNotNegative, {}, ""},
        {"shadow",
         "slope_bias",
         number,
         "2.0",
         "slope, normal_offset: times the least that a flat surface needs",
         kNotNegative,
         {},
         ""},
        {"shadow",
         "cull",
         word,
         "\"none\"",
         "map: which side of a triangle casts nothing",
         kAny,
         {"none", "back", "front"},
         ""},

        {"fog",
         "mode",
         word,
         "\"none\"",
         "how the surface fades with distance",
         kAny,
         {"none", "linear", "exp", "exp2"},
         ""},
        {"fog", "color", vector, "[0.6, 0.65, 0.7]", "linear RGB", kNotNegative, {}, ""},
        {"fog", "start", number, "5", "linear: distance where fog begins", kAny, {}, ""},
        {"fog", "end", number, "30", "linear: distance where nothing else is seen", kAny, {}, ""},
        {"fog", "density", number, "0.1", "exp, exp2: per world unit", kNotNegative, {}, ""},
        {"fog", "distance", word, "\"radial\"", "from the eye, or from its plane", kAny, {"radial", "planar"}, ""},
        {"fog", "frequency", word, "\"pixel\"", "computed per pixel or per vertex", kAny, {"pixel", "vertex"}, ""},

        {"environment",
         "file",
         text,
         "",
         "light from an equirectangular image: .hdr, .exr; 8 or 16 bits are decoded as sRGB",
         kAny,
         {},
         "\"studio.hdr\""},
        {"environment",
         "sky",
         word,
         "",
         "or from a built-in sky",
         kAny,
         {"studio", "sunset", "gradient"},
         "\"studio\""},
        {"environment", "rotation", number, "0", "degrees about +y", kAny, {}, ""},
        {"environment", "intensity", number, "1", "multiplies its light", kNotNegative, {}, ""},
        {"environment",
         "irradiance",
         word,
         "\"map\"",
         "diffuse light: a map, or nine coefficients",
         kAny,
         {"map", "sh9"},
         ""},
        {"environment", "samples", whole, "2048", "specular light: samples baked for roughness 1", {32, 65536}, {}, ""},
        {"environment",
         "reference",
         whole,
         "0",
         "0: the split sum; else samples a point of the integral itself, in each of three ways",
         {0, 65536},
         {},
         ""},
        {"environment", "on", boolean, "true", "false switches it off", kAny, {}, ""},

        {"material", "name", text, "\"default\"", "what objects call it", kAny, {}, "\"gold\""},
        {"material",
         "model",
         word,
         "\"blinn_phong\"",
         "the reflection model",
         kAny,
         {"unlit", "lambert", "phong", "blinn_phong", "ward", "heidrich_seidel", "cook_torrance"},
         ""},
        {"material", "ambient", vector, "[0.1, 0.1, 0.1]", "m_A", kNotNegative, {}, ""},
        {"material", "diffuse", vector, "[0.7, 0.7, 0.7]", "m_D", kNotNegative, {}, ""},
        {"material", "specular", vector, "[0.3, 0.3, 0.3]", "m_S", kNotNegative, {}, ""},
        {"material", "emission", vector, "[0, 0, 0]", "m_E", kNotNegative, {}, ""},
        {"material", "shininess", number, "32", "h: the exponent of the highlight", kNotNegative, {}, ""},

        {"material",
         "ward_alpha",
         number_pair,
         "",
         "ward: widths of the highlight along the grain and across it; without it from shininess",
         kWardAlpha,
         {},
         "[0.05, 0.4]"},
        {"material",
         "grain",
         vector,
         "[0, 1, 0]",
         "ward with ward_alpha, heidrich_seidel: the way scratches or threads run, in world space",
         kAny,
         {},
         ""},

        {"material", "albedo", vector, "[0.8, 0.8, 0.8]", "cook_torrance: base colour", kShare, {}, "[1, 0.78, 0.34]"},
        {"material", "metallic", number, "0", "cook_torrance: 0 dielectric, 1 metal", kShare, {}, ""},
        {"material", "roughness", number, "0.5", "cook_torrance: alpha = roughness^2", kShare, {}, ""},
        {"material", "ao", number, "1", "cook_torrance: share of the environment's light that arrives", kShare, {}, ""},
        {"material", "distribution", word, "\"ggx\"", "cook_torrance: D", kAny, keys_of(lighting::kDistributions), ""},
        {"material", "geometry", word, "\"schlick_ggx\"", "cook_torrance: G", kAny, keys_of(lighting::kGeometries), ""},
        {"material", "fresnel", word, "\"schlick\"", "cook_torrance: F", kAny, keys_of(lighting::kFresnelMethods), ""},
        {"material",
         "table_size",
         whole,
         "256",
         "fresnel = \"table\": samples from 90 degrees to 0",
         {2, 65536},
         {},
         ""},
        {"material",
         "nvidia",
         vector,
         "",
         "fresnel = \"nvidia\": bias, scale, power; without it F0, 1 - F0, 5",
         kNotNegative,
         {},
         "[0.04, 0.96, 5]"},
        {"material",
         "f82",
         vector,
         "",
         "fresnel = \"f82\": colour at 82 degrees; without it from n and k",
         kShare,
         {},
         "[0.83, 0.86, 0.89]"},
        {"material",
         "energy_compensation",
         word,
         "\"none\"",
         "cook_torrance: light that bounces more than once",
         kAny,
         {"none", "kulla_conty"},
         ""},
        {"material",
         "ior",
         vector,
         "",
         "cook_torrance: n per channel; F0 then comes from n and k",
         kPositive,
         {},
         "[0.18, 0.42, 1.37]"},
        {"material",
         "extinction",
         vector,
         "",
         "cook_torrance: k per channel, with ior; without it 0",
         kNotNegative,
         {},
         "[3.42, 2.35, 1.77]"},

        {"material", "measured", word, "", "cook_torrance: n and k as somebody measured them; a metal is metallic = 1",
         kAny, measured_names(), "\"gold\""},
        {"material",
         "spectrum",
         word,
         "\"full\"",
         "of measured: every wavelength, or 685, 535, 475 nm alone",
         kAny,
         {"full", "three"},
         ""},
        {"material", "outside_ior", number, "1", "n of what lies before the surface: 1.33 under water", kIndex, {}, ""},

        {"material",
         "albedo_map",
         text,
         "",
         "cook_torrance: an image (sRGB) instead of albedo",
         kAny,
         {},
         "\"rust_albedo.png\""},
        {"material",
         "metallic_map",
         text,
         "",
         "cook_torrance: an image (linear) instead of metallic",
         kAny,
         {},
         "\"rust_metallic.png\""},
        {"material",
         "roughness_map",
         text,
         "",
         "cook_torrance: an image (linear) instead of roughness",
         kAny,
         {},
         "\"rust_roughness.png\""},
        {"material", "ao_map", text, "", "cook_torrance: an image (linear) instead of ao", kAny, {}, "\"rust_ao.png\""},
        {"material",
         "diffuse_map",
         text,
         "",
         "all models but cook_torrance: an image (sRGB) instead of diffuse",
         kAny,
         {},
         "\"bricks.png\""},
        {"material",
         "emission_map",
         text,
         "",
         "an image (sRGB) times emission, which is [1, 1, 1] beside it",
         kAny,
         {},
         "\"lamp_emission.png\""},
        {"material",
         "normal_map",
         text,
         "",
         "all models but unlit: tilts of the normal, in tangent space",
         kAny,
         {},
         "\"rust_normal.png\""},
        {"material",
         "bump_map",
         text,
         "",
         "instead of normal_map: heights (linear), whose slopes tilt the normal",
         kAny,
         {},
         "\"rust_height.png\""},
        {"material",
         "bump_scale",
         number,
         "0.02",
         "bump_map: how far white stands above black, in widths of the picture",
         kAny,
         {},
         ""},
        {"material",
         "maps",
         text,
         "",
         "a folder with albedo, metallic, roughness, ao, normal: they are told by name",
         kAny,
         {},
         "\"rusted_iron/*.png\""},
        {"material",
         "normal_map_y",
         word,
         "\"up\"",
         "which way green points: up (OpenGL) or down (DirectX)",
         kAny,
         {"up", "down"},
         ""},
        {"material",
         "texture_filter",
         word,
         "\"trilinear\"",
         "how a texture is read between its texels",
         kAny,
         {"nearest", "bilinear", "trilinear"},
         ""},
        {"material",
         "texture_scale",
         number_pair,
         "[1, 1]",
         "how often a texture is laid over 0..1 of u and v",
         kPositive,
         {},
         "[4, 2]"},
        {"material",
         "texture_wrap",
         word,
         "\"repeat\"",
         "what lies outside of a texture",
         kAny,
         {"repeat", "clamp"},
         ""},

        {"object", "mesh", text, "", "an OBJ file, or a built-in shape", kAny, {}, "\"teapot\""},
        {"object",
         "detail",
         whole,
         "",
         "built-in shapes: subdivisions; each shape has its own default",
         {1, 4096},
         {},
         "64"},
        {"object",
         "normals",
         word,
         "\"file\"",
         "file: its own (smooth where it has none)",
         kAny,
         {"file", "smooth", "flat"},
         ""},
        {"object",
         "crease",
         number,
         "",
         "where normals are made: sharper edges stay edges, degrees; without it 60, and a scan's specks are smoothed",
         {0, 180},
         {},
         "30"},
        {"object", "material", text, "", "without it, the OBJ's own MTL materials", kAny, {}, "\"gold\""},
        {"object", "translate", vector, "[0, 0, 0]", "moved last", kPlace, {}, ""},
        {"object", "rotate", vector, "[0, 0, 0]", "degrees about x, then y, then z", kAny, {}, "[0, 45, 0]"},
        {"object", "scale", number_or_vector, "[1, 1, 1]", "scaled first; not 0", kPlace, {}, ""},
        {"object", "hide", texts, "[]", "parts (OBJ groups or objects) that are not drawn", kAny, {}, "[\"lid\"]"},
        {"object", "casts_shadow", boolean, "true", "whether it throws shadows; it receives them anyway", kAny, {}, ""},
    };
}

std::string plain(double number) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%g", number);
    return buffer;
}

/// " > 0", " >= 0", " in 1..8" or nothing where any number will do.
std::string range_text(const Range& range) {
    const bool unbounded_above = range.greatest >= Range{}.greatest;
    if (range.least <= Range{}.least && unbounded_above) return "";
    if (range.least == kPositive.least && unbounded_above) return " > 0";
    if (unbounded_above) return " >= " + plain(range.least);
    return std::string(range.open ? " between " : " in ") + plain(range.least) + (range.open ? " and " : "..") +
           plain(range.greatest);
}

std::string words_text(const KeyInfo& info) {
    std::string text;
    for (const std::string_view word : info.words) {
        text += (text.empty() ? "\"" : " | \"") + std::string(word) + "\"";
    }
    return text;
}

}  // namespace

const std::vector<KeyInfo>& scene_keys() {
    static const std::vector<KeyInfo> keys = make_keys();
    return keys;
}

const KeyInfo* find_key(std::string_view table, std::string_view key) {
    for (const KeyInfo& info : scene_keys()) {
        if (info.table == table && info.key == key) return &info;
    }
    return nullptr;
}

std::vector<std::string> table_names() {
    std::vector<std::string> names;
    for (const KeyInfo& info : scene_keys()) {
        if (names.empty() || names.back() != info.table) names.emplace_back(info.table);
    }
    return names;
}

std::vector<std::string> key_names(std::string_view table) {
    std::vector<std::string> names;
    for (const KeyInfo& info : scene_keys()) {
        if (info.table == table) names.emplace_back(info.key);
    }
    return names;
}

bool is_repeated(std::string_view table) {
    return table == "light" || table == "material" || table == "object";
}

std::string table_title(std::string_view table) {
    const std::string name(table);
    return is_repeated(table) ? "[[" + name + "]]" : "[" + name + "]";
}

std::string type_text(const KeyInfo& info) {
    const std::string range = range_text(info.range);
    switch (info.type) {
        case boolean: return "true or false";
        case whole: return "a whole number" + range;
        case whole_pair: return "2 whole numbers" + range;
        case number: return "a number" + range;
        case number_pair: return "2 numbers" + range;
        case vector: return "3 numbers" + range;
        case number_or_vector: return "a number or 3 numbers" + range;
        case vector_or_word: return "3 numbers" + range + " or " + words_text(info);
        case word: return words_text(info);
        case text: return "text in quotes";
        case texts: return "a list of texts in quotes";
    }
    return "";
}

std::string default_text(const KeyInfo& info) {
    return std::string(info.key) + (info.default_value.empty() ? "" : " = " + std::string(info.default_value));
}

std::string example_text(const KeyInfo& info) {
    const std::string_view value = info.example.empty() ? info.default_value : info.example;
    return std::string(info.key) + " = " + std::string(value);
}

}  // namespace kreda::scene
