#include "shadows/light_view.hpp"

#include <algorithm>
#include <cmath>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "raster/camera.hpp"

namespace kreda::shadows {

namespace {

/// How much larger a picture of `size` texels must be for `margin` of them to stay free on each side. A picture that
/// is all margin grows threefold and has to do.
float with_margin(int size, int margin) {
    const int rest = std::max(size - 2 * margin, 1);
    return std::min(static_cast<float>(size) / static_cast<float>(rest), 3.0f);
}

/// Rows right, up, backward of a camera that looks along `forward`.
glm::mat3 rows(const glm::dvec3& forward, const glm::dvec3& up_hint) {
    const raster::ViewAxes axes = raster::view_axes(forward, up_hint);
    return glm::mat3(glm::transpose(glm::dmat3(axes.right, axes.up, -axes.forward)));
}

LightView perspective_view(const glm::mat3& view_from_world, const glm::vec3& position, float tangent, float near,
                           float far) {
    LightView view;
    view.view_from_world = view_from_world;
    view.origin = position;
    view.perspective = true;
    view.half_size = glm::vec2(tangent);
    view.near = near;
    view.far = far;
    return view;
}

}  // namespace

glm::mat4 clip_from_world(const LightView& view) {
    const double x = view.half_size.x, y = view.half_size.y, n = view.near, f = view.far;
    const glm::dmat4 clip_from_view =
        view.perspective ? glm::frustumRH_NO(-n * x, n * x, -n * y, n * y, n, f) : glm::orthoRH_NO(-x, x, -y, y, n, f);
    glm::dmat4 view_from_world(glm::dmat3(view.view_from_world));
    const glm::dvec3 moved = -(glm::dmat3(view.view_from_world) * glm::dvec3(view.origin));
    view_from_world[3] = glm::dvec4(moved, 1.0);
    return glm::mat4(clip_from_view * view_from_world);
}

glm::mat3 light_axes(const glm::vec3& direction) {
    const bool steep = std::abs(direction.y) >= 0.99f;
    return rows(glm::dvec3(direction), steep ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0));
}

LightBounds bounds_along(const glm::mat3& axes, std::span<const glm::vec3> points) {
    LightBounds bounds;
    for (const glm::vec3& p : points) {
        const glm::vec3 view = axes * p;
        const glm::vec3 q(view.x, view.y, -view.z);
        bounds.least = bounds.empty ? q : glm::min(bounds.least, q);
        bounds.greatest = bounds.empty ? q : glm::max(bounds.greatest, q);
        bounds.empty = false;
    }
    return bounds;
}

LightBounds join(const LightBounds& a, const LightBounds& b) {
    if (a.empty) return b;
    if (b.empty) return a;
    return {glm::min(a.least, b.least), glm::max(a.greatest, b.greatest), false};
}

bool can_cast_onto(const LightBounds& casters, const LightBounds& seen) {
    if (casters.empty || seen.empty) return false;
    const bool overlap_x = casters.least.x <= seen.greatest.x && seen.least.x <= casters.greatest.x;
    const bool overlap_y = casters.least.y <= seen.greatest.y && seen.least.y <= casters.greatest.y;
    const bool before = casters.least.z <= seen.greatest.z;
    return overlap_x && overlap_y && before;
}

LightView directional_view(const glm::vec3& direction, const LightBounds& casters, const LightBounds& seen, int size,
                           int margin) {
    const glm::vec2 least = glm::max(glm::vec2(casters.least), glm::vec2(seen.least));
    const glm::vec2 greatest = glm::min(glm::vec2(casters.greatest), glm::vec2(seen.greatest));
    const glm::vec2 middle = 0.5f * (least + greatest);
    const float extent = std::max({greatest.x - least.x, greatest.y - least.y, 1e-6f});
    const float depth = casters.greatest.z - casters.least.z;
    const float slack = 1e-3f * std::max(depth, extent);  // room for rounding: nothing that casts may be clipped
    LightView view;
    view.view_from_world = light_axes(direction);
    view.origin = glm::transpose(view.view_from_world) * glm::vec3(middle, slack - casters.least.z);
    const glm::vec2 half = 0.5f * (greatest - least) + glm::vec2(1e-3f * extent);
    view.half_size = half * with_margin(size, margin);
    view.near = 0.0f;
    view.far = depth + 2.0f * slack;
    return view;
}

LightView spot_view(const ShadowLight& light, float near, float far, int size, int margin) {
    // In double and rounded once: C libraries differ in the last bit of a float's tangent.
    const double angle = glm::radians(double{std::clamp(light.outer_cone_deg, 0.1f, kWidestSpotDeg)});
    const float tangent = static_cast<float>(std::tan(angle));
    return perspective_view(light_axes(light.direction), light.position, tangent * with_margin(size, margin), near,
                            far);
}

std::array<LightView, 6> cube_views(const glm::vec3& position, float near, float far, int size, int margin) {
    const glm::dvec3 x(1.0, 0.0, 0.0), y(0.0, 1.0, 0.0), z(0.0, 0.0, 1.0);
    const float tangent = with_margin(size, margin);
    const auto face = [&](const glm::dvec3& forward, const glm::dvec3& up) {
        return perspective_view(rows(forward, up), position, tangent, near, far);
    };
    return {face(x, y), face(-x, y), face(y, z), face(-y, z), face(z, y), face(-z, y)};
}

}  // namespace kreda::shadows
