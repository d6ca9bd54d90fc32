#include "scene/plan/plan_warnings.hpp"

#include <algorithm>

#include "scene/extent.hpp"
#include "scene/plan/left_out.hpp"

namespace kreda::scene {

namespace {

/// "light.2", as --set names it.
std::string key_of_light(std::size_t k) {
    return "light." + std::to_string(k);
}

std::string warn_of_light(const Scene& scene, const Seen& seen, std::size_t k) {
    const lighting::Light& light = scene.lights[k];
    if (light.color * light.intensity == glm::vec3(0.0f)) {
        return key_of_light(k) + " sends nothing: color times intensity is 0; write on = false, or make it brighter";
    }
    if (any_of(seen.reached[k])) return "";
    if (light.type == lighting::LightType::spot) {
        return key_of_light(k) +
               " reaches nothing that is seen: nothing lies in its cone and faces it; check position, "
               "direction and cone";
    }
    return key_of_light(k) + " reaches nothing that is seen: it shines on the backs alone; check its " +
           (light.type == lighting::LightType::directional ? "direction" : "position");
}

bool anything_is_lit(const Scene& scene, const RenderPlan& plan) {
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        if (plan.lighting.seen[m] && is_lit(scene.materials[m])) return true;
    }
    return false;
}

void warn_of_lights(const Scene& scene, const RenderPlan& plan, std::vector<std::string>& warnings) {
    const bool lit = anything_is_lit(scene, plan);
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        if (!scene.lights[k].on) continue;
        const std::string warning = lit ? warn_of_light(scene, *plan.seen, k)
                                        : key_of_light(k) + " lights nothing: everything that is seen is unlit";
        if (!warning.empty()) warnings.push_back(warning);
    }
}

/// A shadow of a light that shines, and onto nothing.
void warn_of_shadows(const Scene& scene, const RenderPlan& plan, std::vector<std::string>& warnings) {
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        const auto is_its = [&](const PlannedShadow& shadow) { return shadow.light == static_cast<int>(k); };
        const bool asked = scene.lights[k].on && scene.lights[k].shadow && any_of(plan.lighting.lamps[k]);
        if (!asked || std::any_of(plan.shadows.begin(), plan.shadows.end(), is_its)) continue;
        warnings.push_back(key_of_light(k) +
                           " has shadow = true, but nothing can cast onto what is seen; remove it, or move what casts");
    }
}

/// Behind the camera, before near, beyond far, beside the picture: by the box around the object.
std::string where_outside(const Scene& scene, const Object& object) {
    const Box box = box_of(drawn_points(object));
    const glm::vec3 forward = view_direction(scene.camera);
    float least = 3e38f, greatest = -3e38f;
    for (const glm::vec3& p : box.corners()) {
        const float depth = glm::dot(p - scene.camera.position, forward);
        least = std::min(least, depth);
        greatest = std::max(greatest, depth);
    }
    if (greatest <= 0.0f) return "it lies behind the camera; move it, or turn the camera (camera.target)";
    if (greatest < scene.camera.near) return "it lies nearer than camera.near; make near smaller";
    if (least > scene.camera.far) return "it lies beyond camera.far; make far larger";
    if (seen_corners(box, scene).empty()) return "it lies beside the picture; move it, or turn the camera";
    return "it is smaller than a sample, or beside the picture; move it, or take more samples (image.samples)";
}

std::string why_not_seen(const Scene& scene, const Object& object, const raster::TriangleCounts& triangles) {
    if (triangles.drawn > 0) return "others stand before it; move it, or remove it";
    if (triangles.culled > 0 && triangles.outside == 0) {
        return "all its triangles face away; shading.cull = \"none\" shows backs";
    }
    if (triangles.outside == 0 && triangles.degenerate > 0) return "its triangles have no area; make it larger (scale)";
    return where_outside(scene, object);
}

bool is_hidden(const Object& object) {
    return std::find(object.part_hidden.begin(), object.part_hidden.end(), false) == object.part_hidden.end();
}

/// What is not seen, and casts no shadow onto what is.
void warn_of_objects(const Scene& scene, const RenderPlan& plan, std::vector<std::string>& warnings) {
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const SeenObject& seen = plan.seen->objects[o];
        if (seen.samples > 0 || is_hidden(scene.objects[o])) continue;
        const auto is_cast = [&](const PlannedShadow& shadow) {
            return std::find(shadow.casters.begin(), shadow.casters.end(), static_cast<int>(o)) != shadow.casters.end();
        };
        if (std::any_of(plan.shadows.begin(), plan.shadows.end(), is_cast)) continue;
        warnings.push_back("object." + std::to_string(o) + " (" + scene.objects[o].mesh_name +
                           "): nothing of it is seen: " + why_not_seen(scene, scene.objects[o], seen.triangles));
    }
}

}  // namespace

std::vector<std::string> plan_warnings(const Scene& scene, const RenderPlan& plan) {
    std::vector<std::string> warnings;
    if (!plan.seen || scene.objects.empty()) return warnings;
    if (!plan.draws_objects) { warnings.push_back("the picture shows nothing but background: no object is seen"); }
    warn_of_objects(scene, plan, warnings);
    if (!plan.draws_objects || !plan.film) return warnings;
    warn_of_lights(scene, plan, warnings);
    warn_of_shadows(scene, plan, warnings);
    return warnings;
}

}  // namespace kreda::scene
