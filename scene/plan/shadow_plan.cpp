#include "scene/plan/shadow_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>

#include "scene/extent.hpp"

namespace kreda::scene {

namespace {

using shadows::LightBounds;
using shadows::LightKind;
using shadows::LightView;
using shadows::ShadowLight;

/// What the planning needs to know of an object.
struct ObjectExtent {
    int object = 0;
    bool casts = true;
    std::vector<glm::vec3> points;  ///< world space
    Box box;
    std::optional<Plane> plane;   ///< if it is flat
    std::vector<glm::vec3> seen;  ///< corners of what may be seen of it
};

std::vector<ObjectExtent> measure_objects(const Scene& scene, bool only_visible) {
    std::vector<ObjectExtent> extents;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        ObjectExtent extent;
        extent.object = static_cast<int>(i);
        extent.casts = scene.objects[i].casts_shadow;
        extent.points = drawn_points(scene.objects[i]);
        if (extent.points.empty()) continue;
        extent.box = box_of(extent.points);
        extent.plane = common_plane(extent.points);
        const std::array<glm::vec3, 8> corners = extent.box.corners();
        extent.seen = only_visible ? seen_corners(extent.box, scene) : std::vector(corners.begin(), corners.end());
        extents.push_back(std::move(extent));
    }
    return extents;
}

ShadowLight source_of(const lighting::Light& light) {
    ShadowLight source;
    switch (light.type) {
        case lighting::LightType::directional: source.kind = LightKind::directional; break;
        case lighting::LightType::point: source.kind = LightKind::point; break;
        case lighting::LightType::spot: source.kind = LightKind::spot; break;
    }
    source.direction = glm::vec3(glm::normalize(glm::dvec3(light.direction)));
    source.position = light.position;
    source.outer_cone_deg = light.outer_cone_deg;
    return source;
}

/// A flat object casts nothing onto itself, and nothing onto what lies on the light's side of it: a floor under a scene
/// need not be drawn from the light, and the picture need not be as large as the floor.
bool lies_before_all(const Plane& plane, const ShadowLight& light, const std::vector<ObjectExtent>& extents) {
    const float height_of_light = light.kind == LightKind::directional
                                      ? -glm::dot(plane.normal, light.direction)
                                      : glm::dot(plane.normal, light.position) - plane.offset;
    for (const ObjectExtent& other : extents) {
        const float size = glm::length(other.box.greatest - other.box.least);
        for (const glm::vec3& p : other.seen) {
            const float height = glm::dot(plane.normal, p) - plane.offset;
            const bool behind = height_of_light < 0.0f ? height > 1e-4f * size : height < -1e-4f * size;
            if (behind) return false;
        }
    }
    return true;
}

std::vector<const ObjectExtent*> collect_casters(const ShadowLight& light, const std::vector<ObjectExtent>& extents) {
    std::vector<const ObjectExtent*> casters;
    for (const ObjectExtent& extent : extents) {
        if (!extent.casts) continue;
        if (extent.plane && lies_before_all(*extent.plane, light, extents)) continue;
        casters.push_back(&extent);
    }
    return casters;
}

/// Parallel rays: drop what throws its shadow past everything seen, then fit the picture.
bool fit_directional(const shadows::ShadowSettings& settings, const std::vector<ObjectExtent>& extents,
                     std::vector<const ObjectExtent*>& casters, PlannedShadow& shadow) {
    const glm::mat3 axes = shadows::light_axes(shadow.source.direction);
    LightBounds seen, casting;
    for (const ObjectExtent& extent : extents) seen = join(seen, shadows::bounds_along(axes, extent.seen));
    std::vector<const ObjectExtent*> kept;
    for (const ObjectExtent* caster : casters) {
        const LightBounds bounds = shadows::bounds_along(axes, caster->points);
        if (!can_cast_onto(bounds, seen)) continue;
        casting = join(casting, bounds);
        kept.push_back(caster);
    }
    casters = kept;
    if (casters.empty()) return false;
    shadow.map.views = {
        directional_view(shadow.source.direction, casting, seen, settings.size, shadows::filter_margin(settings))};
    return true;
}

float distance_to(const Box& box, const glm::vec3& p) {
    const glm::vec3 outside = glm::max(glm::max(box.least - p, p - box.greatest), glm::vec3(0.0f));
    return glm::length(outside);
}

float farthest_of(const std::vector<glm::vec3>& points, const glm::vec3& from) {
    float farthest = 0.0f;
    for (const glm::vec3& p : points) farthest = std::max(farthest, glm::length(p - from));
    return farthest;
}

/// Rays from a point: from the nearest caster to the farthest, or to the farthest place that is seen. What is behind
/// that casts upon nothing seen, and the range of depth, of which the bias is a share, ends there.
bool fit_around(const shadows::ShadowSettings& settings, const std::vector<ObjectExtent>& extents,
                const std::vector<const ObjectExtent*>& casters, PlannedShadow& shadow) {
    if (casters.empty()) return false;
    const glm::vec3 light = shadow.source.position;
    float nearest = std::numeric_limits<float>::max(), farthest = 0.0f, farthest_seen = 0.0f;
    for (const ObjectExtent* caster : casters) {
        nearest = std::min(nearest, distance_to(caster->box, light));
        farthest = std::max(farthest, farthest_of(caster->points, light));
    }
    for (const ObjectExtent& extent : extents) farthest_seen = std::max(farthest_seen, farthest_of(extent.seen, light));
    const float far = 1.001f * (farthest_seen > nearest ? std::min(farthest, farthest_seen) : farthest);
    const int margin = shadows::filter_margin(settings);
    const bool one_picture =
        shadow.source.kind == LightKind::spot && shadow.source.outer_cone_deg <= shadows::kWidestSpotDeg;
    const auto views_from = [&](float near) {
        if (one_picture) return std::vector{spot_view(shadow.source, near, far, settings.size, margin)};
        const std::array<LightView, 6> six =
            shadows::cube_views(shadow.source.position, near, far, settings.size, margin);
        return std::vector(six.begin(), six.end());
    };
    // A caster at distance d, in the corner of the picture, is at least d / sqrt(1 + x^2 + y^2) away along the axis.
    // Where it may touch the light a thousandth of the range has to do.
    const glm::vec2 half = views_from(far * 0.5f).front().half_size;
    const float along_axis = 0.999f * nearest / std::sqrt(1.0f + glm::dot(half, half));
    shadow.map.views = views_from(std::max(along_axis, 1e-3f * far));
    return true;
}

/// The flat objects, of which one sees something.
std::vector<ShadowReceiver> collect_receivers(const std::vector<ObjectExtent>& extents) {
    std::vector<ShadowReceiver> receivers;
    for (const ObjectExtent& extent : extents) {
        std::vector<std::uint32_t> indices(extent.points.size());
        std::iota(indices.begin(), indices.end(), 0u);
        const std::optional<glm::dvec4> plane = shadows::plane_of({extent.points, indices, false});
        if (plane && !extent.seen.empty()) receivers.push_back({extent.object, *plane});
    }
    return receivers;
}

}  // namespace

std::string name_of_light(const lighting::Light& light, std::size_t index) {
    const char* kind = light.type == lighting::LightType::directional ? "directional"
                       : light.type == lighting::LightType::point     ? "point"
                                                                      : "spot";
    return "light " + std::to_string(index) + " (" + kind + ")";
}

ShadowPlan plan_shadows(const Scene& scene, bool only_visible, const std::vector<bool>& shines) {
    ShadowPlan plan;
    const auto casts = [&](const lighting::Light& light) {
        return light.on && light.shadow && shines[static_cast<std::size_t>(&light - scene.lights.data())];
    };
    if (std::none_of(scene.lights.begin(), scene.lights.end(), casts)) return plan;
    const std::vector<ObjectExtent> extents = measure_objects(scene, only_visible);
    int on = 0;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const lighting::Light& light = scene.lights[i];
        const int light_that_is_on = on;
        on += light.on;
        if (!casts(light)) continue;
        PlannedShadow shadow;
        shadow.light = static_cast<int>(i);
        shadow.light_that_is_on = light_that_is_on;
        shadow.source = source_of(light);
        shadow.map.settings = scene.shadow;
        std::vector<const ObjectExtent*> casters = collect_casters(shadow.source, extents);
        const bool needed = shadow.source.kind == LightKind::directional
                                ? fit_directional(scene.shadow, extents, casters, shadow)
                                : fit_around(scene.shadow, extents, casters, shadow);
        if (!needed) {
            plan.why_not.push_back(name_of_light(light, i) +
                                   " has shadow = true, but nothing can cast onto what is seen");
            continue;
        }
        if (scene.shadow.method == shadows::ShadowMethod::planar) shadow.receivers = collect_receivers(extents);
        for (const ObjectExtent* caster : casters) shadow.casters.push_back(caster->object);
        plan.shadows.push_back(std::move(shadow));
    }
    return plan;
}

}  // namespace kreda::scene
