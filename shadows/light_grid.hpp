// The visible points as the light sees them: a grid over the light's image plane, each cell a list of the points in it.
// A shadow map samples where its texels are; here the samples are where the picture needs them.          Johnson et al.
// 2005
#pragma once

#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "shadows/shadow.hpp"

namespace kreda::shadows {

/// A picture that the light takes, as three linear forms of a world point (p, 1): it is seen at (x/w, y/w), and only
/// where w > 0. Directional: w = 1. Point and spot: one of the six faces of a cube around the light, w the distance
/// along its axis.
struct GridView {
    glm::dvec4 x{0.0}, y{0.0}, w{0.0};  ///< the forms: dot(x, (p, 1)) and so on
};

/// (x, y, w) of a point.
inline glm::dvec3 project(const GridView& view, const glm::vec3& p) {
    const glm::dvec4 q(glm::dvec3(p), 1.0);
    return {glm::dot(view.x, q), glm::dot(view.y, q), glm::dot(view.w, q)};
}

/// The views that a light needs: one for a directional light, six around any other.
[[nodiscard]] std::vector<GridView> grid_views(const ShadowLight& light);

/// Which of the views looks at p; -1 for a point that is where the light is.
[[nodiscard]] int view_of(const ShadowLight& light, const glm::vec3& p);

/// A visible sample in the light's view.
struct LightPoint {
    glm::dvec3 q{0.0};         ///< (x, y, w)
    std::uint32_t sample = 0;  ///< its place in the frame
};

/// The points of one view, cell by cell. The grid fits around them, with about one cell a point.
struct LightGrid {
    GridView view;                     ///< the picture that the grid lies on
    glm::dvec2 low{0.0}, high{0.0};    ///< of x/w and y/w
    int columns = 0, rows = 0;         ///< cells
    std::vector<std::uint32_t> begin;  ///< cell c = row * columns + column owns points[begin[c] .. begin[c+1])
    std::vector<LightPoint> points;    ///< cell by cell

    /// Place on the grid in cells: column.fraction, row.fraction.
    [[nodiscard]] glm::dvec2 place(const glm::dvec3& q) const {
        const glm::dvec2 seen = glm::dvec2(q) / q.z;
        return (seen - low) / (high - low) * glm::dvec2(columns, rows);
    }
};

/// Sort all visible samples into the grids of the light's views; views that see none have no grid.
[[nodiscard]] std::vector<LightGrid> make_light_grids(const ShadowLight& light, const VisibleSamples& samples);

}  // namespace kreda::shadows
