// Is a mesh what an algorithm expects? Closed, finite, consistently wound, without empty triangles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "raster/mesh.hpp"

namespace kreda::raster {

/// For each vertex the number of its point, points counted from 0 by first appearance. Vertices are one point if their
/// coordinates are bitwise equal (-0 counts as 0). This joins what uv seams and creases have split.
[[nodiscard]] std::vector<std::uint32_t> weld_by_position(std::span<const glm::vec3> positions);

/// (q - p) x (r - p) of triangle pqr in double: along the normal, twice the area long. Exactly zero if the triangle is
/// degenerate: collapsed, collinear, or with a corner that is not finite.
[[nodiscard]] glm::dvec3 twice_area_vector(const Mesh& mesh, std::uint32_t triangle);

/// What check_mesh counts. Edges are those between welded points; a triangle that is collapsed to an edge or a point
/// has no edges.
struct MeshReport {
    std::uint32_t points = 0;                ///< after welding, used by at least one triangle with edges
    std::uint32_t edges = 0;                 ///< each once, however many triangles meet at it
    std::uint32_t faces = 0;                 ///< triangles that have edges
    std::uint32_t degenerate_triangles = 0;  ///< without an area (see twice_area_vector)
    std::uint32_t non_finite_vertices = 0;   ///< with a coordinate that is NaN or infinite
    std::uint32_t bad_triangles = 0;         ///< with an index past the last vertex; left out of everything else
    std::uint32_t open_edges = 0;            ///< one triangle only: a border
    std::uint32_t non_manifold_edges = 0;    ///< three triangles or more
    std::uint32_t flipped_edges = 0;         ///< two triangles that run along it in the same direction
    double area = 0.0;                       ///< of all triangles, square world units
    double signed_volume = 0.0;              ///< > 0 if closed and counter-clockwise outside (divergence theorem)
    glm::vec3 bounds_min{0.0f};              ///< of the finite vertices; both zero if there are none
    glm::vec3 bounds_max{0.0f};              ///< the opposite corner of that box

    /// Every edge belongs to exactly two triangles, in opposite directions.
    [[nodiscard]] bool is_closed() const {
        return open_edges == 0 && non_manifold_edges == 0 && flipped_edges == 0;
    }
    /// V - E + F: 2 for a sphere, 0 for a torus, summed over the components.
    [[nodiscard]] std::int64_t euler_characteristic() const {
        return std::int64_t{points} - std::int64_t{edges} + std::int64_t{faces};
    }
};

/// Counts what is odd about a mesh.
[[nodiscard]] MeshReport check_mesh(const Mesh& mesh);

}  // namespace kreda::raster
