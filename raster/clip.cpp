#include "raster/clip.hpp"

#include <glm/geometric.hpp>

#include "raster/scalar_math.hpp"

namespace kreda::raster {

namespace {

/// Where the edge from `inside` to `outside` meets the plane with the given distances (d_in >= 0 > d_out).
/// Always computed from the inner end: two triangles that share the edge get the same point, to the last bit.
ClipVertex intersect(const ClipVertex& inside, float d_in, const ClipVertex& outside, float d_out) {
    const float t = d_in / (d_in - d_out);
    return {inside.position + t * (outside.position - inside.position),
            inside.weights + t * (outside.weights - inside.weights)};
}

/// Keep the part of a convex polygon where dot(plane, position) >= 0.
ClipPolygon clip_by_plane(const ClipPolygon& in, const glm::vec4& plane) {
    ClipPolygon out;
    for (int i = 0; i < in.count; ++i) {
        const ClipVertex& here = in.vertex[i];
        const ClipVertex& next = in.vertex[(i + 1) % in.count];
        const float d_here = glm::dot(plane, here.position);
        const float d_next = glm::dot(plane, next.position);
        if (out.count + 2 > static_cast<int>(out.vertex.size())) break;
        if (d_here >= 0.0f) out.vertex[out.count++] = here;
        if (d_here >= 0.0f && d_next < 0.0f) out.vertex[out.count++] = intersect(here, d_here, next, d_next);
        if (d_here < 0.0f && d_next >= 0.0f) out.vertex[out.count++] = intersect(next, d_next, here, d_here);
    }
    return out;
}

bool all_finite(const glm::vec4& v) {
    return is_finite(v.x) && is_finite(v.y) && is_finite(v.z) && is_finite(v.w);
}

}  // namespace

ClipPolygon clip_triangle(const glm::vec4& a, const glm::vec4& b, const glm::vec4& c, float guard_x, float guard_y) {
    if (!all_finite(a) || !all_finite(b) || !all_finite(c)) return {};
    ClipPolygon polygon;
    polygon.vertex[0] = {a, {1.0f, 0.0f, 0.0f}};
    polygon.vertex[1] = {b, {0.0f, 1.0f, 0.0f}};
    polygon.vertex[2] = {c, {0.0f, 0.0f, 1.0f}};
    polygon.count = 3;
    const std::array<glm::vec4, 6> planes = {
        glm::vec4(0.0f, 0.0f, 1.0f, 1.0f),  // near first: afterwards w > 0
        glm::vec4(0.0f, 0.0f, -1.0f, 1.0f), glm::vec4(1.0f, 0.0f, 0.0f, guard_x), glm::vec4(-1.0f, 0.0f, 0.0f, guard_x),
        glm::vec4(0.0f, 1.0f, 0.0f, guard_y), glm::vec4(0.0f, -1.0f, 0.0f, guard_y)};
    for (const glm::vec4& plane : planes) polygon = clip_by_plane(polygon, plane);
    if (polygon.count < 3) return {};
    return polygon;
}

}  // namespace kreda::raster
