#include "raster/mesh_checks.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace kreda::raster {

namespace {

using PositionBits = std::array<std::uint32_t, 3>;

PositionBits position_bits(glm::vec3 p) {
    const glm::vec3 q = p + 0.0f;  // turns -0 into +0
    return {std::bit_cast<std::uint32_t>(q.x), std::bit_cast<std::uint32_t>(q.y), std::bit_cast<std::uint32_t>(q.z)};
}

/// Mixes all bits into the low ones: grids of round coordinates differ in few bits only (multipliers: splitmix64).
std::uint64_t hash_bits(const PositionBits& bits) {
    std::uint64_t h = 0;
    for (const std::uint32_t word : bits) {
        h = (h ^ word) * 0xbf58476d1ce4e5b9u;
        h ^= h >> 31;
        h *= 0x94d049bb133111ebu;
        h ^= h >> 30;
    }
    return h;
}

bool is_finite(glm::vec3 p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

void check_vertices(const Mesh& mesh, MeshReport& report) {
    bool is_first = true;
    for (const glm::vec3 p : mesh.positions) {
        if (!is_finite(p)) {
            ++report.non_finite_vertices;
            continue;
        }
        report.bounds_min = is_first ? p : glm::min(report.bounds_min, p);
        report.bounds_max = is_first ? p : glm::max(report.bounds_max, p);
        is_first = false;
    }
}

/// A side of a triangle: its two points, low first, and whether the triangle runs from low to high.
struct DirectedSide {
    std::uint64_t points = 0;
    bool is_forward = true;
};

void append_sides(std::vector<DirectedSide>& sides, const std::array<std::uint32_t, 3>& corners) {
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t from = corners[k], to = corners[(k + 1) % 3];
        const std::uint64_t low = std::min(from, to), high = std::max(from, to);
        sides.push_back({low << 32 | high, from < to});
    }
}

/// Sides sorted by their points lie together when they are one edge.
void count_edges(std::vector<DirectedSide>& sides, MeshReport& report) {
    std::ranges::sort(sides, {}, &DirectedSide::points);
    for (std::size_t first = 0; first < sides.size();) {
        std::size_t last = first + 1;
        while (last < sides.size() && sides[last].points == sides[first].points) ++last;
        const std::size_t triangles = last - first;
        ++report.edges;
        if (triangles == 1) ++report.open_edges;
        if (triangles > 2) ++report.non_manifold_edges;
        if (triangles == 2 && sides[first].is_forward == sides[first + 1].is_forward) ++report.flipped_edges;
        first = last;
    }
}

}  // namespace

std::vector<std::uint32_t> weld_by_position(std::span<const glm::vec3> positions) {
    constexpr std::uint32_t kEmpty = 0xffffffffu;
    std::vector<std::uint32_t> slots(std::bit_ceil(2 * positions.size() + 1), kEmpty);  // open addressing, half empty
    std::vector<std::uint32_t> point_of_vertex(positions.size());
    std::vector<PositionBits> points;
    for (std::size_t vertex = 0; vertex < positions.size(); ++vertex) {
        const PositionBits bits = position_bits(positions[vertex]);
        std::size_t slot = hash_bits(bits) & (slots.size() - 1);
        while (slots[slot] != kEmpty && points[slots[slot]] != bits) slot = (slot + 1) & (slots.size() - 1);
        if (slots[slot] == kEmpty) {
            slots[slot] = static_cast<std::uint32_t>(points.size());
            points.push_back(bits);
        }
        point_of_vertex[vertex] = slots[slot];
    }
    return point_of_vertex;
}

glm::dvec3 twice_area_vector(const Mesh& mesh, std::uint32_t triangle) {
    const std::size_t i = 3 * std::size_t{triangle};
    const glm::dvec3 p(mesh.positions[mesh.indices[i]]);
    const glm::dvec3 q(mesh.positions[mesh.indices[i + 1]]);
    const glm::dvec3 r(mesh.positions[mesh.indices[i + 2]]);
    const glm::dvec3 cross = glm::cross(q - p, r - p);
    // In double the products of float coordinates neither overflow nor underflow, so NaN comes from NaN and inf only.
    const bool has_area = std::isfinite(glm::length(cross));
    return has_area ? cross : glm::dvec3(0.0);
}

MeshReport check_mesh(const Mesh& mesh) {
    MeshReport report;
    check_vertices(mesh, report);
    const std::vector<std::uint32_t> point_of_vertex = weld_by_position(mesh.positions);
    std::vector<bool> is_used(mesh.positions.size(), false);
    std::vector<DirectedSide> sides;
    sides.reserve(mesh.indices.size());
    for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        const std::uint32_t* vertices = &mesh.indices[3 * std::size_t{t}];
        if (std::max({vertices[0], vertices[1], vertices[2]}) >= mesh.positions.size()) {
            ++report.bad_triangles;
            continue;
        }
        const glm::dvec3 area2 = twice_area_vector(mesh, t);
        const bool is_degenerate = area2 == glm::dvec3(0.0);
        if (is_degenerate) ++report.degenerate_triangles;
        report.area += 0.5 * glm::length(area2);
        if (!is_degenerate) report.signed_volume += glm::dot(glm::dvec3(mesh.positions[vertices[0]]), area2) / 6.0;

        const std::array<std::uint32_t, 3> corners = {point_of_vertex[vertices[0]], point_of_vertex[vertices[1]],
                                                      point_of_vertex[vertices[2]]};
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
        ++report.faces;
        append_sides(sides, corners);
        for (const std::uint32_t point : corners) is_used[point] = true;
    }
    report.points = static_cast<std::uint32_t>(std::ranges::count(is_used, true));
    count_edges(sides, report);
    return report;
}

}  // namespace kreda::raster
