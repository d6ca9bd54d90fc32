// The irregular z-buffer: occluders are drawn into the light's grid of visible points, and each point in a touched cell
// is tested exactly. Hard shadows without a resolution and without a bias.     Johnson et al. 2005; Aila & Laine 2004
#pragma once

#include <cstddef>

#include "shadows/light_grid.hpp"
#include "shadows/light_ray.hpp"

namespace kreda::shadows {

/// A triangle in the light's view, made ready for the points of its cells.
struct LightTriangle {
    Triangle world;                    ///< world space
    glm::dvec3 edge[3];                ///< lines through the projected corners: dot(edge, q) > 0 on one side
    glm::dvec2 corner[8]{};            ///< the part that the grid sees, in cells: a convex polygon
    int corner_count = 0;              ///< 0: the grid does not see it
    int first_row = 0, last_row = -1;  ///< that it may touch
};

/// The edges of a triangle whose corners are q in a view; all else of it is not set.
inline LightTriangle with_edges(const Triangle& world, const glm::dvec3 (&q)[3]) {
    LightTriangle triangle;
    triangle.world = world;
    for (int i = 0; i < 3; ++i) triangle.edge[i] = glm::cross(q[i], q[(i + 1) % 3]);
    return triangle;
}

/// Edges and corners of a triangle on the light's grid.
[[nodiscard]] LightTriangle set_up(const LightGrid& grid, const Triangle& world);

/// The cells of a row that the triangle may touch, at least those it does touch.     Empty where first > last.
struct CellRange {
    int first = 0, last = -1;  ///< columns, both included
};
/// First and last cell of a row that the triangle touches.
[[nodiscard]] CellRange cells_in_row(const LightGrid& grid, const LightTriangle& triangle, int row);

/// Does the triangle stand between the light and the point p, seen at q?
///
/// An edge through the projected corners A and B is the line A x B; the point is inside where A x B . q has the same
/// sign for all three edges (Olano & Greer 1997). A x B = -(B x A) exactly, so no point falls between two triangles.
inline bool shadows_point(const LightTriangle& t, const glm::dvec3& q, const glm::dvec4& light, const glm::vec3& p) {
    const double U = glm::dot(t.edge[0], q);
    const double V = glm::dot(t.edge[1], q);
    const double W = glm::dot(t.edge[2], q);
    const bool any_negative = (U < 0.0) | (V < 0.0) | (W < 0.0);
    const bool any_positive = (U > 0.0) | (V > 0.0) | (W > 0.0);
    return any_negative != any_positive && separates(t.world, light, p);
}

/// Bytes that irregular_shadow takes while it runs: points and cells, the points once more while they are sorted, and
/// the casters' triangles as the light sees them.
[[nodiscard]] std::size_t bytes_to_draw_irregular(std::size_t samples, std::size_t triangles);

/// One factor for every visible sample: 1 lit, 0 in shadow.
void irregular_shadow(std::span<const Occluder> occluders, const ShadowLight& light, const VisibleSamples& samples,
                      std::span<float> shadow);

}  // namespace kreda::shadows
