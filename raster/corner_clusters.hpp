// Corners that get one normal: which they are, and how a mesh is split between them. For the functions of normals.hpp.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "raster/mesh.hpp"

namespace kreda::raster {

/// Disjoint sets over 0 .. count - 1 (Tarjan 1975, with path halving); the least member is a set's name. Over corners:
/// corner c is a place in mesh.indices and belongs to triangle c / 3.
struct Clusters {
    std::vector<std::uint32_t> parent;  ///< a member of the same set, itself for the least one

    /// `count` sets of one member each.
    explicit Clusters(std::size_t count);

    /// Name of the set that holds the member.
    std::uint32_t find(std::uint32_t member);
    /// Makes one set of the two.
    void unite(std::uint32_t a, std::uint32_t b);
};

/// An edge that two triangles share, with the corners of both at its two points.
struct SharedEdge {
    std::uint32_t low_corner_a = 0, high_corner_a = 0;  ///< corners of the first triangle
    std::uint32_t low_corner_b = 0, high_corner_b = 0;  ///< those of the second, at the same points

    /// Number of the first triangle.
    [[nodiscard]] std::uint32_t triangle_a() const {
        return low_corner_a / 3;
    }
    /// Number of the second one.
    [[nodiscard]] std::uint32_t triangle_b() const {
        return low_corner_b / 3;
    }
    /// Both triangles get one normal at both points of the edge.
    void join(Clusters& corners) const {
        corners.unite(low_corner_a, low_corner_b);
        corners.unite(high_corner_a, high_corner_b);
    }
};

/// The area vector of every triangle (twice_area_vector), exactly 0 if it is degenerate.
[[nodiscard]] std::vector<glm::dvec3> all_area_vectors(const Mesh& mesh);

/// All edges between triangles that have an area; vertices at bitwise equal positions are one point. An edge of more
/// than two triangles is shared by each with the next one in the order of the triangles.
[[nodiscard]] std::vector<SharedEdge> shared_edges(const Mesh& mesh, const std::vector<glm::dvec3>& area_vectors);

/// Normal of a sum of area vectors, or +y and one more on the count where opposite triangles cancel to nothing.
[[nodiscard]] glm::vec3 normal_or_up(glm::dvec3 sum, std::uint32_t& unknown);

/// Gives every cluster of corners the normal of its summed area vectors; a vertex with several clusters is split.
/// Returns how many vertices have no normal: they get +y.
std::uint32_t give_normals(Mesh& mesh, Clusters& clusters, const std::vector<glm::dvec3>& area_vectors);

}  // namespace kreda::raster
