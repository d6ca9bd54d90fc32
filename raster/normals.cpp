#include "raster/normals.hpp"

#include <cmath>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "raster/corner_clusters.hpp"
#include "raster/mesh_checks.hpp"
#include "raster/platform.hpp"
#include "raster/specks.hpp"

namespace kreda::raster {

namespace {

constexpr double kDefaultCreaseDeg = 60.0;

/// Angle between the faces of at most crease_angle_deg? The slack keeps an edge of exactly that angle smooth: 1e-6 in
/// the cosine covers normals from float positions.
bool is_smooth_edge(glm::dvec3 area_a, glm::dvec3 area_b, double crease_angle_deg) {
    if (crease_angle_deg >= 180.0) return true;
    const double cos_angle = glm::dot(area_a, area_b) / (glm::length(area_a) * glm::length(area_b));
    return cos_angle >= std::cos(glm::radians(crease_angle_deg)) - 1e-6;
}

/// The edges whose faces meet at a larger angle.
std::vector<bool> find_creases(const std::vector<SharedEdge>& edges, const std::vector<glm::dvec3>& area_vectors,
                               double crease_angle_deg) {
    std::vector<bool> is_crease(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const glm::dvec3 a = area_vectors[edges[i].triangle_a()], b = area_vectors[edges[i].triangle_b()];
        is_crease[i] = !is_smooth_edge(a, b, crease_angle_deg);
    }
    return is_crease;
}

/// The corners of a point that are linked by edges without a crease.
Clusters join_corners(std::size_t corners, const std::vector<SharedEdge>& edges, const std::vector<bool>& is_crease) {
    Clusters clusters(corners);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (!is_crease[i]) edges[i].join(clusters);
    }
    return clusters;
}

}  // namespace

std::uint32_t make_smooth_normals(Mesh& mesh, float crease_angle_deg) {
    KREDA_EXPECT(crease_angle_deg >= 0.0f);
    const std::vector<glm::dvec3> area_vectors = all_area_vectors(mesh);
    const std::vector<SharedEdge> edges = shared_edges(mesh, area_vectors);
    const std::vector<bool> is_crease = find_creases(edges, area_vectors, double{crease_angle_deg});
    Clusters clusters = join_corners(3 * area_vectors.size(), edges, is_crease);
    return give_normals(mesh, clusters, area_vectors);
}

std::uint32_t make_smooth_normals_without_specks(Mesh& mesh) {
    const std::vector<glm::dvec3> area_vectors = all_area_vectors(mesh);
    const std::vector<SharedEdge> edges = shared_edges(mesh, area_vectors);
    std::vector<bool> is_crease = find_creases(edges, area_vectors, kDefaultCreaseDeg);
    smooth_over_specks(mesh.triangle_count(), edges, is_crease);
    Clusters clusters = join_corners(3 * area_vectors.size(), edges, is_crease);
    return give_normals(mesh, clusters, area_vectors);
}

std::uint32_t make_smooth_normals_by_group(Mesh& mesh, std::span<const std::uint32_t> smoothing_group_of_triangle) {
    KREDA_EXPECT(smoothing_group_of_triangle.size() == mesh.triangle_count());
    const std::vector<glm::dvec3> area_vectors = all_area_vectors(mesh);
    const std::vector<std::uint32_t> point_of_vertex = weld_by_position(mesh.positions);
    Clusters clusters(3 * std::size_t{mesh.triangle_count()});
    std::unordered_map<std::uint64_t, std::uint32_t> first_corner;  // (point, group) -> a corner of its cluster
    for (std::uint32_t corner = 0; corner < clusters.parent.size(); ++corner) {
        const std::uint32_t group = smoothing_group_of_triangle[corner / 3];
        if (group == 0 || area_vectors[corner / 3] == glm::dvec3(0.0)) continue;
        const std::uint64_t key = std::uint64_t{point_of_vertex[mesh.indices[corner]]} << 32 | group;
        clusters.unite(first_corner.try_emplace(key, corner).first->second, corner);
    }
    return give_normals(mesh, clusters, area_vectors);
}

std::uint32_t make_flat_normals(Mesh& mesh) {
    const Mesh source = std::move(mesh);
    mesh = Mesh{};
    mesh.parts = source.parts;
    std::uint32_t unknown = 0;
    for (std::uint32_t corner = 0; corner < 3 * source.triangle_count(); ++corner) {
        const std::uint32_t vertex = source.indices[corner];
        mesh.positions.push_back(source.positions[vertex]);
        if (!source.uvs.empty()) mesh.uvs.push_back(source.uvs[vertex]);
        mesh.normals.push_back(normal_or_up(twice_area_vector(source, corner / 3), unknown));
        mesh.indices.push_back(corner);
    }
    return unknown;
}

}  // namespace kreda::raster
