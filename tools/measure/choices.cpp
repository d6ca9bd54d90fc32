#include "tools/measure/choices.hpp"

#include "raster/platform.hpp"
#include "scene/files/scene_keys.hpp"

namespace kreda::tools {

namespace {

/// The values of a term whose key is a word: the words of the key.
Choice of_words(std::string_view name, std::string_view table, std::string_view key, std::string oracle,
                std::string_view why_oracle, std::string_view valid) {
    const scene::KeyInfo* info = scene::find_key(table, key);
    KREDA_EXPECT(info != nullptr);
    return {name, table, key, {info->words.begin(), info->words.end()}, std::move(oracle), why_oracle, valid};
}

/// A ladder of numbers; the last is the oracle.
Choice of_numbers(std::string_view name, std::string_view table, std::string_view key, const std::vector<int>& ladder,
                  std::string_view why_oracle, std::string_view valid) {
    KREDA_EXPECT(scene::find_key(table, key) != nullptr);
    Choice choice{name, table, key, {}, std::to_string(ladder.back()), why_oracle, valid};
    for (const int number : ladder) choice.values.push_back(std::to_string(number));
    return choice;
}

constexpr std::string_view kEverywhere = "everywhere";
constexpr std::string_view kMicrofacet = "model = \"cook_torrance\"";
constexpr std::string_view kOnMap = "shadow.method = \"map\"";

std::vector<Choice> picture_choices() {
    return {
        of_numbers("supersampling", "image", "samples", {1, 2, 3, 4, 6, 8}, "64 points of every pixel", kEverywhere),
        of_words("transfer function", "image", "transfer", "srgb", "what a display does", kEverywhere),
        of_words("shading frequency", "shading", "frequency", "phong", "light where it is seen",
                 "not with shadows that are found at the pixels"),
        of_numbers("shading rate", "shading", "rate", {4, 3, 2, 1}, "a point for every sample",
                   "shading.frequency = \"phong\""),
        of_words("interpolation", "shading", "interpolation", "perspective", "what a perspective does", kEverywhere),
        of_numbers("tessellation", "object", "detail", {8, 16, 32, 64, 128}, "triangles smaller than a pixel",
                   "built-in shapes"),
    };
}

std::vector<Choice> shadow_choices() {
    return {
        of_words("shadow method", "shadow", "method", "exact", "a ray to the light", "where the method can answer"),
        of_numbers("shadow map's size", "shadow", "size", {256, 512, 1024, 2048, 4096}, "texels smaller than a pixel",
                   kOnMap),
        of_words("shadow filter", "shadow", "filter", "", "soft and hard shadows are of different lights", kOnMap),
        of_numbers("width of pcf", "shadow", "radius", {1, 2, 4}, "the widest", "shadow.filter = \"pcf\""),
        of_words("shadow bias", "shadow", "bias", "slope", "the least that a flat surface needs", kOnMap),
    };
}

std::vector<Choice> environment_choices() {
    return {
        of_words("irradiance", "environment", "irradiance", "map", "the sum over every texel", "reference = 0"),
        of_numbers("prefilter samples", "environment", "samples", {32, 128, 512, 2048, 8192}, "the most samples",
                   "reference = 0"),
        {"split sum",
         "environment",
         "reference",
         {"0", "64", "256"},
         "256",
         "the integral itself, sampled at every point",
         "where something is lit by an environment"},
    };
}

std::vector<Choice> fog_choices() {
    return {
        of_words("fog distance", "fog", "distance", "radial", "what the light goes through", "where there is fog"),
        of_words("fog frequency", "fog", "frequency", "pixel", "fog where it is seen", "where there is fog"),
    };
}

std::vector<Choice> material_choices() {
    return {
        of_words("distribution of facets", "material", "distribution", "", "each is another surface", kMicrofacet),
        of_words("masking and shadowing", "material", "geometry", "smith_correlated",
                 "follows from GGX's facets (Heitz 2014)", "distribution = \"ggx\""),
        of_words("Fresnel", "material", "fresnel", "exact", "Fresnel's equations for n and k, or for F0",
                 "some methods need n and k, one a channel"),
        of_numbers("size of Fresnel's table", "material", "table_size", {16, 64, 256, 1024}, "the most entries",
                   "fresnel = \"table\""),
        of_words("wavelengths", "material", "spectrum", "full", "every wavelength that was measured", "measured"),
        of_words("multiple scattering", "material", "energy_compensation", "kulla_conty",
                 "what bounces twice is not lost", kMicrofacet),
        of_words("texture filter", "material", "texture_filter", "trilinear", "the footprint's mean", "with maps"),
    };
}

/// "exact | schlick | ...", the oracle marked.
std::string values_text(const Choice& choice) {
    std::string text;
    for (const std::string& value : choice.values) {
        text += (text.empty() ? "" : " | ") + value + (value == choice.oracle ? "*" : "");
    }
    return text;
}

}  // namespace

const std::vector<Choice>& choices() {
    static const std::vector<Choice> all = [] {
        std::vector<Choice> joined;
        for (const std::vector<Choice>& some :
             {picture_choices(), shadow_choices(), environment_choices(), fog_choices(), material_choices()}) {
            joined.insert(joined.end(), some.begin(), some.end());
        }
        return joined;
    }();
    return all;
}

const Choice* find_choice(std::string_view table, std::string_view key) {
    for (const Choice& choice : choices()) {
        if (choice.table == table && choice.key == key) return &choice;
    }
    return nullptr;
}

std::string key_of(const Choice& choice) {
    return std::string(choice.table) + "." + std::string(choice.key);
}

std::string describe_choices() {
    std::string text;
    for (const Choice& choice : choices()) {
        text += key_of(choice) + ": " + std::string(choice.name) + "\n    " + values_text(choice) + "\n    ";
        text += choice.oracle.empty() ? "no oracle: " : "* the oracle: ";
        text += std::string(choice.why_oracle) + "; " + std::string(choice.valid) + "\n";
    }
    return text;
}

}  // namespace kreda::tools
