#include "scene/shadow_warnings.hpp"

#include <algorithm>
#include <optional>

#include <glm/geometric.hpp>

#include "raster/mesh_checks.hpp"
#include "scene/extent.hpp"
#include "shadows/light_view.hpp"

namespace kreda::scene {

namespace {

using shadows::ShadowMethod;

std::string name_of(const Scene& scene, std::size_t object) {
    return "object " + std::to_string(object) + " (" + scene.objects[object].mesh_name + ")";
}

/// What the map of parallel rays must hold of an object, and what it casts.
struct Silhouette {
    std::size_t object = 0;
    bool casts = false;
    std::optional<Plane> plane;  ///< if it is flat
    Box box;
    std::vector<glm::vec3> points;  ///< world space
};

float width_along(const glm::mat3& axes, const std::vector<glm::vec3>& points) {
    const shadows::LightBounds bounds = shadows::bounds_along(axes, points);
    return std::max(bounds.greatest.x - bounds.least.x, bounds.greatest.y - bounds.least.y);
}

/// Does some of `other` lie on the side of the plane that the light does not reach?
bool lies_behind(const Silhouette& other, const Plane& plane, const glm::vec3& direction) {
    const float size = glm::length(other.box.greatest - other.box.least);
    const float side = glm::dot(plane.normal, direction) > 0.0f ? 1.0f : -1.0f;
    return std::any_of(other.points.begin(), other.points.end(), [&](const glm::vec3& p) {
        return side * (glm::dot(plane.normal, p) - plane.offset) > 1e-4f * size;
    });
}

/// A flat object of which something lies in the shadow is drawn from the light as a whole: the picture becomes as wide
/// as what is seen of it, and the shadows of small objects a few texels.
std::string too_wide(const Scene& scene, std::size_t light, const std::vector<Silhouette>& objects) {
    constexpr float kLeastTexels = 16.0f;
    const glm::vec3 direction = scene.lights[light].direction;
    const glm::mat3 axes = shadows::light_axes(glm::normalize(direction));
    for (const Silhouette& floor : objects) {
        if (!floor.plane || !floor.casts) continue;
        const bool is_drawn = std::any_of(objects.begin(), objects.end(), [&](const Silhouette& other) {
            return &other != &floor && lies_behind(other, *floor.plane, direction);
        });
        const std::vector<glm::vec3> seen = seen_corners(floor.box, scene);
        if (!is_drawn || seen.empty()) continue;
        const float texel = width_along(axes, seen) / static_cast<float>(scene.shadow.size);
        for (const Silhouette& other : objects) {
            const float texels = width_along(axes, other.points) / texel;
            if (other.plane || !other.casts || texels >= kLeastTexels) continue;
            return "the shadow map of light " + std::to_string(light) + " must hold all of " +
                   name_of(scene, floor.object) + ", in whose shadow something lies; the shadow of " +
                   name_of(scene, other.object) + " is " + std::to_string(static_cast<int>(texels)) +
                   " texels wide there: write casts_shadow = false for " + name_of(scene, floor.object);
        }
    }
    return "";
}

std::vector<Silhouette> silhouettes_of(const Scene& scene) {
    std::vector<Silhouette> objects;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        Silhouette one;
        one.object = i;
        one.points = drawn_points(scene.objects[i]);
        if (one.points.empty()) continue;
        one.casts = scene.objects[i].casts_shadow;
        one.plane = common_plane(one.points);
        one.box = box_of(one.points);
        objects.push_back(std::move(one));
    }
    return objects;
}

void add_wide_maps(const Scene& scene, std::vector<std::string>& warnings) {
    if (scene.shadow.method != ShadowMethod::map) return;
    std::vector<Silhouette> objects;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const lighting::Light& light = scene.lights[i];
        if (!light.on || !light.shadow || light.type != lighting::LightType::directional) continue;
        if (objects.empty()) objects = silhouettes_of(scene);
        const std::string warning = too_wide(scene, i, objects);
        if (!warning.empty()) warnings.push_back(warning);
    }
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
    add_wide_maps(scene, warnings);
    return warnings;
}

}  // namespace kreda::scene
