// The keys of [[material]] and [[object]].
#include "lighting/microfacet_choices.hpp"
#include "lighting/spectrum.hpp"
#include "scene/files/key_tables.hpp"

namespace kreda::scene {

namespace {

using lighting::CookTorranceMaterial;
using lighting::Material;
using lighting::MaterialMaps;
using lighting::PhongMaterial;

constexpr Range kIndex{0.1, 10.0};
constexpr Range kIor{0.01, 100.0}, kExtinction{0.0, 100.0};  // beside kIndex within the domain of lighting/fresnel.hpp
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

template <class Member>
auto phong(Member member) {
    return within(&Material::phong, member);
}

template <class Member>
auto microfacet(Member member) {
    return within(&Material::cook_torrance, member);
}

template <class Member>
auto maps(Member member) {
    return within(&Material::maps, member);
}

/// The name of an image: read_maps() looks for the file.
Key<Material> map_row(std::string_view key, std::string_view meaning, std::string_view example) {
    return own_row<Material>(key, KeyType::text, meaning, {.example = example});
}

using MaterialKeys = std::vector<Key<Material>>;

/// What all models read, and what all but cook_torrance read.
MaterialKeys local_keys() {
    using M = Material;
    using P = PhongMaterial;
    return {
        row<M>("name", &M::name, "what objects call it", {.example = "\"gold\""}),
        row<M>("model", &M::model, "the reflection model",
               {.words = {"unlit", "lambert", "phong", "blinn_phong", "ward", "heidrich_seidel", "cook_torrance"}}),
        row<M>("ambient", phong(&P::ambient), "m_A", {.range = kNotNegative}),
        row<M>("diffuse", phong(&P::diffuse), "m_D", {.range = kNotNegative}),
        row<M>("specular", phong(&P::specular), "m_S", {.range = kNotNegative}),
        row<M>("emission", phong(&P::emission), "m_E", {.range = kNotNegative}),
        row<M>("shininess", phong(&P::shininess), "h: the exponent of the highlight", {.range = kNotNegative}),
        row<M>("ward_alpha", phong(&P::ward_alpha),
               "ward: widths of the highlight along the grain and across it; without it from shininess",
               {.range = kWardAlpha, .example = "[0.05, 0.4]"}),
        row<M>("grain", phong(&P::grain),
               "ward with ward_alpha, heidrich_seidel: the way scratches or threads run, in world space"),
    };
}

/// What cook_torrance reads.
MaterialKeys microfacet_keys() {
    using M = Material;
    using C = CookTorranceMaterial;
    return {
        row<M>("albedo", microfacet(&C::albedo), "cook_torrance: base colour",
               {.range = kShare, .example = "[1, 0.78, 0.34]"}),
        row<M>("metallic", microfacet(&C::metallic), "cook_torrance: 0 dielectric, 1 metal", {.range = kShare}),
        row<M>("roughness", microfacet(&C::roughness), "cook_torrance: alpha = roughness^2", {.range = kShare}),
        row<M>("ao", microfacet(&C::ao), "cook_torrance: share of the environment's light that arrives",
               {.range = kShare}),
        row<M>("distribution", microfacet(&C::distribution), "cook_torrance: D",
               {.words = keys_of(lighting::kDistributions)}),
        row<M>("geometry", microfacet(&C::geometry), "cook_torrance: G", {.words = keys_of(lighting::kGeometries)}),
        row<M>("fresnel", microfacet(&C::fresnel), "cook_torrance: F", {.words = keys_of(lighting::kFresnelMethods)}),
        row<M>("table_size", microfacet(&C::table_size), "fresnel = \"table\": samples from 90 degrees to 0",
               {.range = {2, 65536}}),
        row<M>("nvidia", microfacet(&C::nvidia), "fresnel = \"nvidia\": bias, scale, power; without it F0, 1 - F0, 5",
               {.range = kNotNegative, .example = "[0.04, 0.96, 5]"}),
        row<M>("f82", microfacet(&C::f82), "fresnel = \"f82\": colour at 82 degrees; without it from n and k",
               {.range = kShare, .example = "[0.83, 0.86, 0.89]"}),
        row<M>("energy_compensation", microfacet(&C::energy_compensation),
               "cook_torrance: light that bounces more than once", {.words = {"none", "kulla_conty"}}),
        row<M>("ior", microfacet(&C::ior), "cook_torrance: n per channel; F0 then comes from n and k",
               {.range = kIor, .example = "[0.18, 0.42, 1.37]"}),
        row<M>("extinction", microfacet(&C::extinction), "cook_torrance: k per channel, with ior; without it 0",
               {.range = kExtinction, .example = "[3.42, 2.35, 1.77]"}),
        row<M>("measured", microfacet(&C::measured),
               "cook_torrance: n and k as somebody measured them; a metal is metallic = 1",
               {.words = measured_names(), .example = "\"gold\""}),
        row<M>("spectrum", microfacet(&C::spectrum), "of measured: every wavelength, or 685, 535, 475 nm alone",
               {.words = {"full", "three"}}),
        row<M>("outside_ior", microfacet(&C::outside_ior), "n of what lies before the surface: 1.33 under water",
               {.range = kIndex}),
    };
}

MaterialKeys map_keys() {
    using M = Material;
    using T = MaterialMaps;
    return {
        map_row("albedo_map", "cook_torrance: an image (sRGB) instead of albedo", "\"rust_albedo.png\""),
        map_row("metallic_map", "cook_torrance: an image (linear) instead of metallic", "\"rust_metallic.png\""),
        map_row("roughness_map", "cook_torrance: an image (linear) instead of roughness", "\"rust_roughness.png\""),
        map_row("ao_map", "cook_torrance: an image (linear) instead of ao", "\"rust_ao.png\""),
        map_row("diffuse_map", "all models but cook_torrance: an image (sRGB) instead of diffuse", "\"bricks.png\""),
        map_row("emission_map", "an image (sRGB) times emission, which is [1, 1, 1] beside it",
                "\"lamp_emission.png\""),
        map_row("normal_map", "all models but unlit: tilts of the normal, in tangent space", "\"rust_normal.png\""),
        map_row("bump_map", "instead of normal_map: heights (linear), whose slopes tilt the normal",
                "\"rust_height.png\""),
        row<M>("bump_scale", maps(&T::bump_scale),
               "bump_map: how far white stands above black, in widths of the picture"),
        map_row("maps", "a folder with albedo, emission, metallic, roughness, ao, normal: they are told by name",
                "\"rusted_iron/*.png\""),
        row<M>("normal_map_y", maps(&T::normal_y), "which way green points: up (OpenGL) or down (DirectX)",
               {.words = {"up", "down"}}),
        row<M>("texture_filter", maps(&T::filter), "how a texture is read between its texels",
               {.words = {"nearest", "bilinear", "trilinear"}}),
        row<M>("texture_scale", maps(&T::scale), "how often a texture is laid over 0..1 of u and v",
               {.range = kPositive, .example = "[4, 2]"}),
        row<M>("texture_wrap", maps(&T::wrap), "what lies outside of a texture", {.words = {"repeat", "clamp"}}),
    };
}

}  // namespace

const std::vector<Key<Material>>& material_keys() {
    static const MaterialKeys keys = [] {
        MaterialKeys all = local_keys();
        for (const MaterialKeys& more : {microfacet_keys(), map_keys()})
            all.insert(all.end(), more.begin(), more.end());
        return rows_of<Material>("material", all);
    }();
    return keys;
}

const std::vector<Key<ObjectTable>>& object_keys() {
    using T = ObjectTable;
    const auto placement = [](auto member) { return within(&T::placement, member); };
    static const std::vector<Key<T>> keys = rows_of<T>(
        "object",
        {
            row<T>("mesh", &T::mesh, "an OBJ file, or a built-in shape", {.example = "\"teapot\""}),
            row<T>("detail", &T::detail, "built-in shapes: subdivisions; each shape has its own default",
                   {.range = {1, 4096}, .example = "64"}),
            row<T>("normals", &T::normals, "file: its own (smooth where it has none)",
                   {.words = {"file", "smooth", "flat"}}),
            row<T>("crease", &T::crease,
                   "where normals are made: sharper edges stay edges, degrees; without it 60, and a scan's specks are "
                   "smoothed",
                   {.range = {0, 180}, .example = "30"}),
            row<T>("material", &T::material, "without it, the OBJ's own MTL materials", {.example = "\"gold\""}),
            row<T>("translate", placement(&ObjectPlacement::translate), "moved last", {.range = kPlace}),
            row<T>("rotate", placement(&ObjectPlacement::rotate_deg), "degrees about x, then y, then z",
                   {.example = "[0, 45, 0]"}),
            own_row<T>("scale", KeyType::number_or_vector, "scaled first; not 0",
                       {.range = kPlace, .by_default = "[1, 1, 1]"},
                       [](const Value& value, T& object) {
                           object.placement.scale = glm::dvec3(value.number);
                           if (!value.items.empty()) set_member(value, object.placement.scale);
                       }),
            own_row<T>("hide", KeyType::texts, "parts (OBJ groups or objects) that are not drawn",
                       {.example = "[\"lid\"]", .by_default = "[]"}),
            row<T>("casts_shadow", &T::casts_shadow, "whether it throws shadows; it receives them anyway"),
            row<T>("on", &T::on, "whether it is there; if not, its mesh is not even read"),
        });
    return keys;
}

}  // namespace kreda::scene
