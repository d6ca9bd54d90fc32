#include "scene/files/unread_keys.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "scene/files/scene_keys.hpp"
#include "scene/microfacet_material.hpp"

namespace kreda::scene {

namespace {

using lighting::CookTorranceMaterial;
using lighting::Material;
using lighting::ReflectionModel;

bool is_empirical(const Material& m) {
    return m.model != ReflectionModel::cook_torrance;
}
bool has_ambient(const Material& m) {
    return is_empirical(m) && m.model != ReflectionModel::unlit;
}
bool has_highlight(const Material& m) {
    return has_ambient(m) && m.model != ReflectionModel::lambert;
}
bool has_exponent(const Material& m) {
    return has_highlight(m) && (m.model != ReflectionModel::ward || !m.phong.ward_alpha);
}
bool is_ward(const Material& m) {
    return m.model == ReflectionModel::ward;
}
bool has_grain(const Material& m) {
    return m.model == ReflectionModel::heidrich_seidel || (is_ward(m) && m.phong.ward_alpha);
}
bool uses_table(const Material& m) {
    return is_microfacet(m) && m.cook_torrance.fresnel == lighting::FresnelMethod::table;
}
bool uses_nvidia(const Material& m) {
    return is_microfacet(m) && m.cook_torrance.fresnel == lighting::FresnelMethod::nvidia;
}
bool uses_f82(const Material& m) {
    return is_microfacet(m) && m.cook_torrance.fresnel == lighting::FresnelMethod::f82;
}

/// A key, whether a material's model reads it, and what to do where it does not.
struct KeyUse {
    std::string_view key;
    bool (*is_read)(const Material& material);
    std::string_view remedy;
};

constexpr std::string_view kCookTorrance = "only model = \"cook_torrance\" does";
constexpr std::array kKeyUses = {
    KeyUse{"ambient", has_ambient, "remove it"},
    KeyUse{"diffuse", is_empirical, "its colour is albedo"},
    KeyUse{"specular", has_highlight, "remove it, or choose a model with a highlight"},
    KeyUse{"shininess", has_exponent, "remove it; cook_torrance has roughness, ward its ward_alpha"},
    KeyUse{"ward_alpha", is_ward, "only model = \"ward\" does"},
    KeyUse{"grain", has_grain, "heidrich_seidel does, and ward with ward_alpha"},
    KeyUse{"albedo", is_microfacet, "its colour is diffuse"},
    KeyUse{"metallic", is_microfacet, kCookTorrance},
    KeyUse{"roughness", is_microfacet, "the older models have shininess"},
    KeyUse{"ao", is_microfacet, kCookTorrance},
    KeyUse{"distribution", is_microfacet, kCookTorrance},
    KeyUse{"geometry", is_microfacet, kCookTorrance},
    KeyUse{"fresnel", is_microfacet, kCookTorrance},
    KeyUse{"energy_compensation", is_microfacet, kCookTorrance},
    KeyUse{"ior", is_microfacet, kCookTorrance},
    KeyUse{"extinction", is_microfacet, kCookTorrance},
    KeyUse{"measured", is_microfacet, kCookTorrance},
    KeyUse{"spectrum", is_microfacet, kCookTorrance},
    KeyUse{"outside_ior", is_microfacet, kCookTorrance},
    KeyUse{"table_size", uses_table, "only fresnel = \"table\" does"},
    KeyUse{"nvidia", uses_nvidia, "only fresnel = \"nvidia\" does"},
    KeyUse{"f82", uses_f82, "only fresnel = \"f82\" does"},
    KeyUse{"albedo_map", is_microfacet, "its map is diffuse_map"},
    KeyUse{"metallic_map", is_microfacet, kCookTorrance},
    KeyUse{"roughness_map", is_microfacet, kCookTorrance},
    KeyUse{"ao_map", is_microfacet, kCookTorrance},
    KeyUse{"diffuse_map", is_empirical, "its map is albedo_map"},
};

/// The words of a scene file for the chosen model.
std::string model_text(const Material& material) {
    const std::string_view word = find_key("material", "model")->words[static_cast<std::size_t>(material.model)];
    return "model = " + in_quotes(word, '"');
}

float linear_of_byte(double byte) {
    const double s = byte / 255.0;
    return static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
}

/// Three whole numbers up to 255 that no share and no brightness of light would be.
bool looks_like_bytes(const Value& value) {
    constexpr double kTooBright = 16.0;
    if (value.kind != ValueKind::array || value.items.size() != 3) return false;
    double greatest = 0.0;
    for (const Value& item : value.items) {
        const bool is_byte = item.number >= 0.0 && item.number <= 255.0 && item.number == std::floor(item.number);
        if (!is_byte) return false;
        greatest = std::max(greatest, item.number);
    }
    return greatest >= kTooBright;
}

bool is_color_key(std::string_view key) {
    constexpr std::array<std::string_view, 5> kColors = {"color", "diffuse", "specular", "ambient", "background"};
    return std::find(kColors.begin(), kColors.end(), key) != kColors.end();
}

void add_byte_colors(const Value& value, std::vector<std::string>& warnings) {
    for (const Value& item : value.items) add_byte_colors(item, warnings);
    if (!is_color_key(value.key) || !looks_like_bytes(value)) return;
    char linear[64];
    std::snprintf(linear, sizeof linear, "[%.3g, %.3g, %.3g]", linear_of_byte(value.items[0].number),
                  linear_of_byte(value.items[1].number), linear_of_byte(value.items[2].number));
    warnings.push_back(
        UserError(value.key_place, in_quotes(value.key) +
                                       " looks like bytes of 0..255; colours are linear light, about 0..1: "
                                       "as sRGB bytes these would be " +
                                       linear)
            .what());
}

/// A material with a colour for either family of models is written to be tried with both: nothing is forgotten there.
bool is_for_either_family(const Value& table) {
    return find(table, "diffuse") && find(table, "albedo");
}

}  // namespace

std::vector<std::string> unread_keys(const Value& table, const Material& material) {
    std::vector<std::string> warnings;
    for (const KeyUse& use : kKeyUses) {
        const Value* const value = find(table, use.key);
        if (!value || use.is_read(material) || is_for_either_family(table)) continue;
        warnings.push_back(UserError(value->key_place, in_quotes(use.key) + " in [[material]] is not read by " +
                                                           model_text(material) + "; " + std::string(use.remedy))
                               .what());
    }
    return warnings;
}

std::vector<std::string> byte_colors(const Value& root) {
    std::vector<std::string> warnings;
    add_byte_colors(root, warnings);
    return warnings;
}

}  // namespace kreda::scene
