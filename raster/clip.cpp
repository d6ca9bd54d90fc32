#include "raster/clip.hpp"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "raster/convex_polygon.hpp"
#include "raster/scalar_math.hpp"
#include "raster/screen.hpp"

namespace kreda::raster {

namespace {

/// A corner while it is being clipped. In double: where a triangle runs from the near plane to far away, w at the cut
/// is the small difference of large numbers, and in float it may come out as zero or below.
struct Corner {
    glm::dvec4 position{0.0};
    glm::dvec3 weights{0.0};
};

using Polygon = ConvexPolygon<Corner, ClipPolygon::kMaxCorners>;

Corner corner_between(const Corner& inside, const Corner& outside, double t) {
    return {inside.position + t * (outside.position - inside.position),
            inside.weights + t * (outside.weights - inside.weights)};
}

/// Keep the part of a convex polygon where dot(plane, position) >= 0, or what that would cut off.
Polygon clip_by_plane(const Polygon& in, const glm::dvec4& plane, bool keep_inside = true) {
    const auto distance = [&](const Corner& corner) { return glm::dot(plane, corner.position); };
    return cut_polygon(in, distance, corner_between, keep_inside);
}

/// Round to float, then put right what rounding moved out of the view: the rest of the pipeline relies on it.
ClipVertex rounded(const Corner& corner, float guard_x, float guard_y, FarSide side) {
    glm::vec4 p(corner.position);
    p.x = std::clamp(p.x, -guard_x * p.w, guard_x * p.w);
    p.y = std::clamp(p.y, -guard_y * p.w, guard_y * p.w);
    p.z = side == FarSide::before ? std::clamp(p.z, -p.w, p.w) : std::max(p.z, p.w);
    return {p, glm::vec3(corner.weights)};
}

/// Does the corner lie clearly beyond the plane: farther than rounding could move what is cut?
bool is_beyond(const glm::vec4& corner, const glm::dvec4& plane) {
    constexpr double kClear = 1e-9;
    const glm::dvec4 p(corner);
    return glm::dot(plane, p) < -kClear * glm::dot(glm::abs(plane), glm::abs(p));
}

bool all_finite(const glm::vec4& v) {
    return is_finite(v.x) && is_finite(v.y) && is_finite(v.z) && is_finite(v.w);
}

}  // namespace

ClipPolygon clip_triangle(const glm::vec4& a, const glm::vec4& b, const glm::vec4& c, float guard_x, float guard_y,
                          FarSide side) {
    if (!all_finite(a) || !all_finite(b) || !all_finite(c)) return {};
    const glm::dvec4 near(0.0, 0.0, 1.0, 1.0), far(0.0, 0.0, -1.0, 1.0);
    const std::array<glm::dvec4, 4> sides = {glm::dvec4(1.0, 0.0, 0.0, guard_x), glm::dvec4(-1.0, 0.0, 0.0, guard_x),
                                             glm::dvec4(0.0, 1.0, 0.0, guard_y), glm::dvec4(0.0, -1.0, 0.0, guard_y)};
    // Most triangles that come here lie wholly beyond one plane.
    const auto all_beyond = [&](const glm::dvec4& plane) {
        return is_beyond(a, plane) && is_beyond(b, plane) && is_beyond(c, plane);
    };
    if (all_beyond(near) || (side == FarSide::before && all_beyond(far))) return {};
    if (std::any_of(sides.begin(), sides.end(), all_beyond)) return {};

    Polygon polygon;
    polygon.corner[0] = {a, {1.0, 0.0, 0.0}};
    polygon.corner[1] = {b, {0.0, 1.0, 0.0}};
    polygon.corner[2] = {c, {0.0, 0.0, 1.0}};
    polygon.count = 3;
    polygon = clip_by_plane(polygon, near);  // near first: afterwards w > 0
    polygon = clip_by_plane(polygon, far, side == FarSide::before);
    for (const glm::dvec4& plane : sides) polygon = clip_by_plane(polygon, plane);
    if (polygon.count < 3) return {};

    ClipPolygon result;
    for (int i = 0; i < polygon.count; ++i) {
        // Corners 1e15 times nearer than the triangle is long: not even double tells them from the eye.
        if (!(polygon.corner[i].position.w >= kMinNormal)) return {};
        result.vertex[result.count++] = rounded(polygon.corner[i], guard_x, guard_y, side);
    }
    return result;
}

}  // namespace kreda::raster
