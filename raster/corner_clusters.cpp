#include "raster/corner_clusters.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "raster/mesh_checks.hpp"

namespace kreda::raster {

namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr glm::vec3 kUnknownNormal{0.0f, 1.0f, 0.0f};

bool is_degenerate(glm::dvec3 area_vector) {
    return area_vector == glm::dvec3(0.0);
}

/// A side of a triangle between two points, with the triangle's corners at both.
struct Side {
    std::uint64_t points = 0;  // low point << 32 | high point
    std::uint32_t low_corner = 0;
    std::uint32_t high_corner = 0;
};

/// Calls visit(side) for all sides of triangles that have an area, in the order of the triangles.
template <class Visit>
void for_each_side(const Mesh& mesh, const std::vector<std::uint32_t>& point_of_vertex,
                   const std::vector<glm::dvec3>& area_vectors, Visit visit) {
    for (std::uint32_t corner = 0; corner < 3 * mesh.triangle_count(); ++corner) {
        if (is_degenerate(area_vectors[corner / 3])) continue;
        const std::uint32_t next = corner % 3 == 2 ? corner - 2 : corner + 1;
        const std::uint64_t from = point_of_vertex[mesh.indices[corner]];
        const std::uint64_t to = point_of_vertex[mesh.indices[next]];
        if (from < to)
            visit(Side{from << 32 | to, corner, next});
        else
            visit(Side{to << 32 | from, next, corner});
    }
}

/// Those of one edge next to each other, in the order of the triangles: first each side goes to the others of its low
/// point, of which there are few, then these are sorted.
std::vector<Side> sorted_sides(const Mesh& mesh, const std::vector<std::uint32_t>& point_of_vertex,
                               const std::vector<glm::dvec3>& area_vectors) {
    std::vector<std::size_t> begin(mesh.positions.size() + 1, 0);  // of each low point's sides
    for_each_side(mesh, point_of_vertex, area_vectors, [&](const Side& side) { ++begin[(side.points >> 32) + 1]; });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Side> sides(begin.back());
    std::vector<std::size_t> end(begin.begin(), begin.end() - 1);
    for_each_side(mesh, point_of_vertex, area_vectors,
                  [&](const Side& side) { sides[end[side.points >> 32]++] = side; });
    const auto comes_before = [](const Side& a, const Side& b) {
        return a.points != b.points ? a.points < b.points : a.low_corner < b.low_corner;
    };
    for (std::size_t point = 0; point < end.size(); ++point) {
        const auto first = sides.begin();
        std::sort(first + std::ptrdiff_t(begin[point]), first + std::ptrdiff_t(end[point]), comes_before);
    }
    return sides;
}

/// The sum of the area vectors of each cluster, at the corner that names it.
std::vector<glm::dvec3> cluster_sums(Clusters& clusters, const std::vector<glm::dvec3>& area_vectors) {
    std::vector<glm::dvec3> sums(clusters.parent.size(), glm::dvec3(0.0));
    for (std::uint32_t corner = 0; corner < sums.size(); ++corner) {
        sums[clusters.find(corner)] += area_vectors[corner / 3];
    }
    return sums;
}

std::uint32_t append_copy(Mesh& mesh, std::uint32_t vertex) {
    const glm::vec3 position = mesh.positions[vertex];
    mesh.positions.push_back(position);
    if (!mesh.uvs.empty()) {
        const glm::vec2 uv = mesh.uvs[vertex];
        mesh.uvs.push_back(uv);
    }
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

/// Gives each vertex one cluster. The first cluster of a vertex keeps it, each further one gets a copy; corners of
/// degenerate triangles have no say and stay with the vertex. Returns the cluster of each vertex, kNone if it has none.
std::vector<std::uint32_t> split_vertices(Mesh& mesh, Clusters& clusters, const std::vector<glm::dvec3>& area_vectors) {
    std::vector<std::uint32_t> cluster_of_vertex(mesh.positions.size(), kNone);
    std::unordered_map<std::uint64_t, std::uint32_t> copies;  // (vertex, cluster) -> copy
    for (std::uint32_t corner = 0; corner < clusters.parent.size(); ++corner) {
        if (is_degenerate(area_vectors[corner / 3])) continue;
        std::uint32_t& vertex = mesh.indices[corner];
        const std::uint32_t cluster = clusters.find(corner);
        if (cluster_of_vertex[vertex] == kNone) cluster_of_vertex[vertex] = cluster;
        if (cluster_of_vertex[vertex] == cluster) continue;
        const auto [copy, is_new] = copies.try_emplace(std::uint64_t{vertex} << 32 | cluster, kNone);
        if (is_new) {
            copy->second = append_copy(mesh, vertex);
            cluster_of_vertex.push_back(cluster);
        }
        vertex = copy->second;
    }
    return cluster_of_vertex;
}

/// A vertex that only degenerate triangles use borrows the first normal found at its point.
void adopt_clusters_by_point(std::vector<std::uint32_t>& cluster_of_vertex, const Mesh& mesh) {
    const std::vector<std::uint32_t> point_of_vertex = weld_by_position(mesh.positions);
    std::vector<std::uint32_t> cluster_of_point(mesh.positions.size(), kNone);
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
        std::uint32_t& cluster = cluster_of_point[point_of_vertex[vertex]];
        if (cluster == kNone) cluster = cluster_of_vertex[vertex];
    }
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
        if (cluster_of_vertex[vertex] == kNone) cluster_of_vertex[vertex] = cluster_of_point[point_of_vertex[vertex]];
    }
}

}  // namespace

Clusters::Clusters(std::size_t count) : parent(count) {
    std::iota(parent.begin(), parent.end(), 0u);
}

std::uint32_t Clusters::find(std::uint32_t member) {
    while (parent[member] != member) member = parent[member] = parent[parent[member]];
    return member;
}

void Clusters::unite(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t root_a = find(a), root_b = find(b);
    parent[std::max(root_a, root_b)] = std::min(root_a, root_b);
}

std::vector<glm::dvec3> all_area_vectors(const Mesh& mesh) {
    std::vector<glm::dvec3> vectors(mesh.triangle_count());
    for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) vectors[t] = twice_area_vector(mesh, t);
    return vectors;
}

std::vector<SharedEdge> shared_edges(const Mesh& mesh, const std::vector<glm::dvec3>& area_vectors) {
    const std::vector<Side> sides = sorted_sides(mesh, weld_by_position(mesh.positions), area_vectors);
    std::vector<SharedEdge> edges;
    edges.reserve(sides.size() / 2);
    for (std::size_t i = 1; i < sides.size(); ++i) {
        const Side &a = sides[i - 1], &b = sides[i];
        if (a.points == b.points) edges.push_back({a.low_corner, a.high_corner, b.low_corner, b.high_corner});
    }
    return edges;
}

/// Normal of a sum, or +y and one more on the count where opposite triangles cancel to nothing.
glm::vec3 normal_or_up(glm::dvec3 sum, std::uint32_t& unknown) {
    const double length = glm::length(sum);
    if (length > 0.0 && std::isfinite(length)) return glm::vec3(sum / length);
    ++unknown;
    return kUnknownNormal;
}

std::uint32_t give_normals(Mesh& mesh, Clusters& clusters, const std::vector<glm::dvec3>& area_vectors) {
    const std::vector<glm::dvec3> sums = cluster_sums(clusters, area_vectors);
    std::vector<std::uint32_t> cluster_of_vertex = split_vertices(mesh, clusters, area_vectors);
    adopt_clusters_by_point(cluster_of_vertex, mesh);
    std::uint32_t unknown = 0;
    mesh.normals.resize(mesh.positions.size());
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
        const std::uint32_t cluster = cluster_of_vertex[vertex];
        mesh.normals[vertex] = normal_or_up(cluster == kNone ? glm::dvec3(0.0) : sums[cluster], unknown);
    }
    return unknown;
}

}  // namespace kreda::raster
