#include "scene/plan/choose_lighting.hpp"

#include <algorithm>

#include "lighting/batch/maps.hpp"
#include "scene/map_meshes.hpp"
#include "scene/microfacet_material.hpp"

namespace kreda::scene {

namespace {

using lighting::Material;
using lighting::ReflectionModel;

constexpr glm::vec3 kBlack(0.0f);

/// Which materials a test holds for.
template <class Test>
MaterialMask mask_of(const Scene& scene, Test test) {
    MaterialMask mask;
    for (std::size_t m = 0; m < scene.materials.size(); ++m) mask.push_back(test(m));
    return mask;
}

bool is_diffuse(const Material& material) {
    return material.phong.diffuse != kBlack || is_given(material.maps.diffuse);
}

/// Can a lamp change what such a surface shows?
bool reflects_lamps(const Material& material) {
    if (!is_lit(material) || is_microfacet(material)) return is_lit(material);
    const bool has_highlight = material.model != ReflectionModel::lambert;
    return is_diffuse(material) || (has_highlight && material.phong.specular != kBlack);
}

/// Can the environment?
bool reflects_environment(const Material& material) {
    if (is_microfacet(material)) return material.cook_torrance.ao != 0.0f || is_given(material.maps.ao);
    return is_lit(material) && is_diffuse(material);
}

/// Does the model read a map that is given, and that matters for what is asked?
bool reads_wanted_map(const Material& material, const Wanted& wanted) {
    const auto matters = [&](const lighting::MapUse& use) {
        const MapNames& names = wanted.map_names;
        const bool asked = names[0].empty() || std::find(names.begin(), names.end(), use.name) != names.end();
        return asked && is_given(material.maps.*use.map) && reads_map(material.model, use);
    };
    return std::ranges::any_of(lighting::map_uses(), matters);
}

/// Does emission come from a map? A factor of 0 before it leaves nothing.
bool emits_by_map(const Material& material) {
    return is_given(material.maps.emission) && material.phong.emission != kBlack;
}

/// Does a map change the sums that are asked for? `is_reached`: some light arrives, so that what it is reflected by
/// matters.
bool map_shows(const Material& material, const Wanted& wanted, bool is_reached) {
    const bool own_light = wanted.radiance || wanted.environment;  // the sum of all, or what is there without lamps
    if (own_light && emits_by_map(material)) return true;
    if (!is_lit(material)) return own_light && is_given(material.maps.diffuse);
    const auto reflects_by = [&](const lighting::MapUse& use) {
        return use.map != &lighting::MaterialMaps::emission && is_given(material.maps.*use.map) &&
               reads_map(material.model, use);
    };
    return is_reached && std::ranges::any_of(lighting::map_uses(), reflects_by);
}

bool is_black(const lighting::Light& light) {
    return light.color * light.intensity == kBlack;
}

int last_light(const Scene& scene) {
    int last = -1;
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        if (scene.lights[k].on) last = static_cast<int>(k);
    }
    return last;
}

/// The materials that light k is added to, for the sum of all lights.
MaterialMask choose_lamp(const Scene& scene, const Seen* seen, const MaterialMask& lit, std::size_t k) {
    if (!seen) return lit;
    const bool dark = is_black(scene.lights[k]);
    return mask_of(scene, [&](std::size_t m) {
        return lit[m] && !dark && reflects_lamps(scene.materials[m]) && seen->reached[k][m];
    });
}

std::vector<MaterialMask> choose_lamps(const Scene& scene, const Seen* seen, const Wanted& wanted,
                                       const MaterialMask& lit) {
    const MaterialMask none(scene.materials.size(), false);
    std::vector<MaterialMask> lamps(scene.lights.size(), none);
    for (std::size_t k = 0; k < lamps.size(); ++k) {
        if (wanted.lamps && scene.lights[k].on) lamps[k] = choose_lamp(scene, seen, lit, k);
    }
    if (const int last = last_light(scene); wanted.last_lamp && last >= 0) lamps[static_cast<std::size_t>(last)] = lit;
    for (std::size_t k = 0; k < lamps.size() && wanted.last_shadow; ++k) {  // which of them has one is not known yet
        if (scene.lights[k].on && scene.lights[k].shadow) lamps[k] = lit;
    }
    return lamps;
}

MaterialMask choose_environment(const Scene& scene, const Seen* seen, const Wanted& wanted, const MaterialMask& lit) {
    const bool on = scene.environment.on && wanted.environment;
    if (!on || (seen && scene.environment.intensity == 0.0f)) return MaterialMask(scene.materials.size(), false);
    // A view of what the environment sends looks at it even where nothing of it is reflected.
    const bool all = !seen || !wanted.effects;
    return mask_of(scene, [&](std::size_t m) { return lit[m] && (all || reflects_environment(scene.materials[m])); });
}

MaterialMask seen_materials(const Scene& scene, const Seen* seen) {
    if (!seen) return visible_materials(scene);
    return mask_of(scene, [&](std::size_t m) { return seen->of_material[m] > 0; });
}

}  // namespace

bool LightingChoices::lit_by_environment() const {
    return any_of(environment);
}

bool LightingChoices::lit_by_lamps() const {
    return std::any_of(lamps.begin(), lamps.end(), [](const MaterialMask& mask) { return any_of(mask); });
}

bool any_of(const MaterialMask& mask) {
    return std::find(mask.begin(), mask.end(), true) != mask.end();
}

bool is_lit(const Material& material) {
    return material.model != ReflectionModel::unlit;
}

LightingChoices nothing_lit(const Scene& scene) {
    const MaterialMask none(scene.materials.size(), false);
    return {none, none, none, none, std::vector<MaterialMask>(scene.lights.size(), none), false};
}

LightingChoices choose_lighting(const Scene& scene, const Seen* seen, const Wanted& wanted) {
    LightingChoices chosen;
    chosen.seen = seen_materials(scene, seen);
    chosen.any = wanted.any_light() && any_of(chosen.seen);
    const MaterialMask lit =
        mask_of(scene, [&](std::size_t m) { return chosen.any && chosen.seen[m] && is_lit(scene.materials[m]); });
    chosen.lamps = choose_lamps(scene, seen, wanted, lit);
    chosen.environment = choose_environment(scene, seen, wanted, lit);
    const auto is_reached = [&](std::size_t m) {
        const auto shines = [&](const MaterialMask& lamp) { return lamp[m]; };
        return chosen.environment[m] || std::any_of(chosen.lamps.begin(), chosen.lamps.end(), shines);
    };
    // The sum needs n and v, and the maps of what is lit, only where light arrives; views look at them anyway.
    const bool looked_at = !seen || !wanted.effects;
    chosen.surface =
        mask_of(scene, [&](std::size_t m) { return lit[m] && wanted.surface && (looked_at || is_reached(m)); });
    chosen.maps = mask_of(scene, [&](std::size_t m) {
        const bool read = chosen.any && wanted.maps && chosen.seen[m] && reads_wanted_map(scene.materials[m], wanted);
        return read && (looked_at || map_shows(scene.materials[m], wanted, is_reached(m)));
    });
    return chosen;
}

}  // namespace kreda::scene
