#include "scene/shadow_warnings.hpp"

#include <algorithm>

#include "raster/mesh_checks.hpp"
#include "scene/extent.hpp"

namespace kreda::scene {

namespace {

using shadows::ShadowMethod;

std::string name_of(const Scene& scene, std::size_t object) {
    return "object " + std::to_string(object) + " (" + scene.objects[object].mesh_name + ")";
}

}  // namespace

std::vector<std::string> shadow_warnings(const Scene& scene) {
    std::vector<std::string> warnings;
    const bool casts = std::any_of(scene.lights.begin(), scene.lights.end(),
                                   [](const lighting::Light& light) { return light.on && light.shadow; });
    if (!casts) return warnings;
    bool any_flat = false;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const bool is_flat = common_plane(drawn_points(object)).has_value();
        any_flat |= is_flat;
        if (scene.shadow.method != ShadowMethod::volume || !object.casts_shadow || is_flat) continue;
        if (raster::check_mesh(*object.mesh).is_closed()) continue;
        warnings.push_back(
            name_of(scene, i) +
            " is not closed: every triangle of its open pieces casts a shadow volume of its own (slower)");
    }
    if (scene.shadow.method == ShadowMethod::planar && !any_flat) {
        warnings.push_back("shadow.method = \"planar\" casts shadows onto flat objects only, and no object is flat");
    }
    return warnings;
}

}  // namespace kreda::scene
