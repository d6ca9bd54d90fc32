#include "scene/files/read_materials.hpp"

#include <set>

#include <glm/geometric.hpp>

#include "lighting/cook_torrance.hpp"
#include "lighting/spectrum.hpp"
#include "scene/files/read_maps.hpp"
#include "scene/files/toml_check.hpp"
#include "scene/files/unread_keys.hpp"

namespace kreda::scene {

namespace {

bool is_metal(const lighting::MeasuredMaterial& material) {
    return material.samples.front().k > 0.0;
}

[[noreturn]] void throw_needs(const Value& key, const std::string& what) {
    throw UserError(key.place, in_quotes(key.key) + " in [[material]] needs " + what);
}

/// n and k: given for three channels, or measured by somebody.
void read_index(const Value& table, lighting::CookTorranceMaterial& material) {
    if (find(table, "ior")) read(table, "ior", material.ior.emplace());
    if (find(table, "extinction")) read(table, "extinction", material.extinction.emplace());
    read(table, "measured", material.measured);
    read_word(table, "spectrum", material.spectrum);
    read(table, "outside_ior", material.outside_ior);
    const Value* const measured = find(table, "measured");
    if (measured && material.ior) {
        throw UserError(measured->place, "'measured' and 'ior' in [[material]] both give n; remove one of them");
    }
    if (const Value* k = find(table, "extinction"); k && !material.ior) {
        throw_needs(*k, "'ior' beside it: a metal has both n and k");
    }
    const Value* const spectrum = find(table, "spectrum");
    if (spectrum && !measured && material.spectrum == lighting::SpectrumUse::three) {
        throw_needs(*spectrum, "'measured': only then more wavelengths are known, e.g. measured = \"gold\"");
    }
    const Value* const outside = find(table, "outside_ior");
    if (outside && !measured && !material.ior && material.outside_ior != 1.0f) {
        throw_needs(*outside, "'ior' or 'measured': n of both sides");
    }
    if (measured && !find(table, "metallic") && is_metal(*lighting::find_measured(material.measured))) {
        material.metallic = 1.0f;
    }
}

/// A method that is fitted to three indices does not know what to do with a spectrum.
void check_fresnel(const Value& table, const lighting::CookTorranceMaterial& material) {
    if (material.measured.empty() || material.spectrum == lighting::SpectrumUse::three) return;
    const Value* const fresnel = find(table, "fresnel");
    if (!fresnel || !needs_three_indices(material.fresnel)) return;
    throw UserError(fresnel->place, "fresnel = " + in_quotes(fresnel->text, '"') +
                                        " works with one n and k a channel; write spectrum = \"three\" beside it, or "
                                        "fresnel = \"f82\" for the whole spectrum");
}

lighting::CookTorranceMaterial read_cook_torrance(const Value& table) {
    lighting::CookTorranceMaterial material;
    read(table, "albedo", material.albedo);
    read(table, "metallic", material.metallic);
    read(table, "roughness", material.roughness);
    read(table, "ao", material.ao);
    read_word(table, "distribution", material.distribution);
    read_word(table, "geometry", material.geometry);
    read_word(table, "fresnel", material.fresnel);
    read_word(table, "energy_compensation", material.energy_compensation);
    read(table, "table_size", material.table_size);
    if (find(table, "nvidia")) read(table, "nvidia", material.nvidia.emplace());
    if (find(table, "f82")) read(table, "f82", material.f82.emplace());
    read_index(table, material);
    check_fresnel(table, material);
    return material;
}

lighting::PhongMaterial read_phong(const Value& table) {
    constexpr double kLeastLength = 1e-9;  // a shorter vector has no direction in float
    lighting::PhongMaterial material;
    read(table, "ambient", material.ambient);
    read(table, "diffuse", material.diffuse);
    read(table, "specular", material.specular);
    read(table, "emission", material.emission);
    read(table, "shininess", material.shininess);
    if (const Value* alpha = find(table, "ward_alpha")) {
        material.ward_alpha =
            glm::vec2(static_cast<float>(alpha->items[0].number), static_cast<float>(alpha->items[1].number));
    }
    read(table, "grain", material.grain);
    if (glm::length(glm::dvec3(material.grain)) < kLeastLength) {
        throw UserError(place_of(table, "grain"),
                        "'grain' in [[material]] has length 0; a direction is e.g. grain = [0, 1, 0]");
    }
    return material;
}

lighting::Material read_material(const Value& table, const std::string& folder, std::vector<std::string>& warnings) {
    lighting::Material material;
    read(table, "name", material.name);
    read_word(table, "model", material.model);
    material.phong = read_phong(table);
    material.cook_torrance = read_cook_torrance(table);
    read_maps(table, folder, material, warnings);
    return material;
}

}  // namespace

void read_materials(const Value& tables, const std::string& folder, Scene& scene) {
    std::set<std::string> names;
    for (const Value& table : tables.items) {
        const lighting::Material material = read_material(table, folder, scene.warnings);
        if (!names.insert(material.name).second) {
            const std::string what = "there is already a material " + in_quotes(material.name);
            throw UserError(place_of(table, "name"), what + "; each [[material]] needs its own name");
        }
        const std::vector<std::string> unread = unread_keys(table, material);
        scene.warnings.insert(scene.warnings.end(), unread.begin(), unread.end());
        scene.materials.push_back(material);
    }
}

}  // namespace kreda::scene
