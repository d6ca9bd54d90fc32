// The (2,3) torus knot (the trefoil) as a tube: twice around the axis while three times around the ring.
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "raster/shape_grid.hpp"
#include "raster/shapes.hpp"

namespace kreda::raster {

namespace {

constexpr double kRingRadius = 1.0;  // R of the torus that carries the knot
constexpr double kCoilRadius = 0.4;  // r of that torus
constexpr double kTubeRadius = 0.2;
// The tube does not touch itself: the strands stay 0.8 apart (0.4 needed) and the knot's curvature stays below 1.31
// (1 / 0.2 = 5 allowed). The knot is 14.776 long.

/// A point of the knot and a right-handed orthonormal frame there: tangent x binormal = normal.
struct KnotFrame {
    glm::dvec3 center, tangent, normal, binormal;
};

/// C(t)  = ((R + r cos 3t) sin 2t, r sin 3t, (R + r cos 3t) cos 2t),   t in [0, 2 pi)
/// The knot lies on a torus, so the torus' own normal is perpendicular to the tangent everywhere. As a frame it closes
/// by itself and has a formula; the Frenet frame needs second derivatives, parallel transport does not close.
KnotFrame knot_frame(double t) {
    const double sin2 = std::sin(2 * t), cos2 = std::cos(2 * t);
    const double sin3 = std::sin(3 * t), cos3 = std::cos(3 * t);
    const double reach = kRingRadius + kCoilRadius * cos3;
    const glm::dvec3 center(reach * sin2, kCoilRadius * sin3, reach * cos2);
    const glm::dvec3 derivative(-3 * kCoilRadius * sin3 * sin2 + 2 * reach * cos2, 3 * kCoilRadius * cos3,
                                -3 * kCoilRadius * sin3 * cos2 - 2 * reach * sin2);
    const glm::dvec3 tangent = glm::normalize(derivative);
    const glm::dvec3 normal(cos3 * sin2, sin3, cos3 * cos2);
    return {center, tangent, normal, glm::cross(normal, tangent)};
}

}  // namespace

Mesh make_torus_knot(int detail) {
    require_detail("torus_knot", detail);
    const int along = detail;
    const int around = detail / 8;
    Mesh mesh;
    for (int i = 0; i <= along; ++i) {
        const KnotFrame frame = knot_frame(2 * std::numbers::pi * (i % along) / along);
        for (int j = 0; j <= around; ++j) {
            const double v = 2 * std::numbers::pi * (j % around) / around;
            const glm::dvec3 normal = std::cos(v) * frame.normal + std::sin(v) * frame.binormal;
            append_vertex(mesh, frame.center + kTubeRadius * normal, normal, {double(i) / along, double(j) / around});
        }
    }
    append_grid_triangles(mesh, 0, along, around);
    close_part(mesh, "torus_knot");
    return mesh;
}

}  // namespace kreda::raster
