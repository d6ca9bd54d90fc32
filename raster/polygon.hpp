// Polygons of any number of corners, convex or not, become triangles by cutting off ears.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace kreda::scene {

/// A polygon cut into triangles.
struct PolygonTriangles {
    std::vector<std::uint32_t> corners;  ///< three a triangle, each an index into the polygon, n - 2 triangles
    /// The triangles' areas sum to the polygon's. False: it has no area, or its outline crosses itself.
    bool area_agrees = true;
};

/// Triangulate a simple polygon of n >= 3 corners, seen along its Newell normal; the triangles wind as it does. A
/// polygon that touches itself (a hole reached by a cut) is fine. One that crosses itself is triangulated as well as
/// can be. Ear clipping (Meisters 1975; Eberly 2002), time O(n²); O(n) where a fan from corner 0 is right.
[[nodiscard]] PolygonTriangles triangulate_polygon(std::span<const glm::vec3> polygon);

/// Newell's normal: its length is twice the polygon's area, for a planar polygon of any shape (Sutherland et al. 1974).
[[nodiscard]] glm::dvec3 newell_normal(std::span<const glm::vec3> polygon);

}  // namespace kreda::scene
