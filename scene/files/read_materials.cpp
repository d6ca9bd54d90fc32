#include "scene/files/read_materials.hpp"

#include <set>

#include <glm/geometric.hpp>

#include "lighting/cook_torrance.hpp"
#include "lighting/spectrum.hpp"
#include "scene/files/key_tables.hpp"
#include "scene/files/read_maps.hpp"
#include "scene/files/unread_keys.hpp"

namespace kreda::scene {

namespace {

bool is_metal(const lighting::MeasuredMaterial& material) {
    return material.samples.front().k > 0.0;
}

[[noreturn]] void throw_needs(const Value& key, const std::string& what) {
    throw UserError(key.place, in_quotes(key.key) + " in [[material]] needs " + what);
}

/// n and k: three numbers each, or a measured material by its name, which is a metal or not.
void settle_index(const Value& table, lighting::CookTorranceMaterial& material) {
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

void check_grain(const Value& table, const lighting::PhongMaterial& material) {
    constexpr double kLeastLength = 1e-9;  // a shorter vector has no direction in float
    if (glm::length(glm::dvec3(material.grain)) >= kLeastLength) return;
    throw UserError(place_of(table, "grain"),
                    "'grain' in [[material]] has length 0; a direction is e.g. grain = [0, 1, 0]");
}

lighting::Material read_material(const Value& table, const std::string& folder, std::vector<std::string>& warnings) {
    lighting::Material material;
    read_keys(table, material_keys(), material);
    check_grain(table, material.phong);
    settle_index(table, material.cook_torrance);
    check_fresnel(table, material.cook_torrance);
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
