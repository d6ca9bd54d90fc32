#include "raster/normals.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "raster/mesh_checks.hpp"
#include "raster/platform.hpp"

namespace kreda::raster {

namespace {

// A corner is a place in mesh.indices: corner c belongs to triangle c / 3. Corners that get one normal form a cluster,
// named by one of its corners.
constexpr std::uint32_t kNone = 0xffffffffu;
constexpr glm::vec3 kUnknownNormal{0.0f, 1.0f, 0.0f};

std::vector<glm::dvec3> all_area_vectors(const Mesh& mesh) {
    std::vector<glm::dvec3> vectors(mesh.triangle_count());
    for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) vectors[t] = twice_area_vector(mesh, t);
    return vectors;
}

bool is_degenerate(glm::dvec3 area_vector) {
    return area_vector == glm::dvec3(0.0);
}

/// Disjoint sets over the corners (Tarjan 1975, with path halving). The smaller corner becomes the name.
struct Clusters {
    std::vector<std::uint32_t> parent;

    explicit Clusters(std::size_t corners) : parent(corners) {
        std::iota(parent.begin(), parent.end(), 0u);
    }

    std::uint32_t find(std::uint32_t corner) {
        while (parent[corner] != corner) corner = parent[corner] = parent[parent[corner]];
        return corner;
    }
    void unite(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t root_a = find(a), root_b = find(b);
        parent[std::max(root_a, root_b)] = std::min(root_a, root_b);
    }
};

/// A side of a triangle between two points, with the triangle's corners at both.
struct Side {
    std::uint64_t points = 0;  // low point << 32 | high point
    std::uint32_t low_corner = 0;
    std::uint32_t high_corner = 0;
};

/// Sides of all triangles that have an area, those of one edge next to each other, in the order of the triangles.
std::vector<Side> sorted_sides(const Mesh& mesh, const std::vector<std::uint32_t>& point_of_vertex,
                               const std::vector<glm::dvec3>& area_vectors) {
    std::vector<Side> sides;
    sides.reserve(mesh.indices.size());
    for (std::uint32_t corner = 0; corner < 3 * mesh.triangle_count(); ++corner) {
        if (is_degenerate(area_vectors[corner / 3])) continue;
        const std::uint32_t next = corner % 3 == 2 ? corner - 2 : corner + 1;
        const std::uint64_t from = point_of_vertex[mesh.indices[corner]];
        const std::uint64_t to = point_of_vertex[mesh.indices[next]];
        if (from < to)
            sides.push_back({from << 32 | to, corner, next});
        else
            sides.push_back({to << 32 | from, next, corner});
    }
    std::ranges::sort(sides, [](const Side& a, const Side& b) {
        return a.points != b.points ? a.points < b.points : a.low_corner < b.low_corner;
    });
    return sides;
}

/// Angle between the faces of at most crease_angle_deg? The slack keeps an edge of exactly that angle smooth: 1e-6 in
/// the cosine covers normals from float positions.
bool is_smooth_edge(glm::dvec3 area_a, glm::dvec3 area_b, double crease_angle_deg) {
    if (crease_angle_deg >= 180.0) return true;
    const double cos_angle = glm::dot(area_a, area_b) / (glm::length(area_a) * glm::length(area_b));
    return cos_angle >= std::cos(glm::radians(crease_angle_deg)) - 1e-6;
}

/// An edge of more than two triangles joins each with the next one in the order of the triangles.
void unite_over_smooth_edges(Clusters& clusters, const std::vector<Side>& sides,
                             const std::vector<glm::dvec3>& area_vectors, double crease_angle_deg) {
    for (std::size_t i = 1; i < sides.size(); ++i) {
        const Side& a = sides[i - 1];
        const Side& b = sides[i];
        if (a.points != b.points) continue;
        if (!is_smooth_edge(area_vectors[a.low_corner / 3], area_vectors[b.low_corner / 3], crease_angle_deg)) continue;
        clusters.unite(a.low_corner, b.low_corner);
        clusters.unite(a.high_corner, b.high_corner);
    }
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

/// Normal of a sum, or +y and one more on the count where opposite triangles cancel to nothing.
glm::vec3 normal_or_up(glm::dvec3 sum, std::uint32_t& unknown) {
    const double length = glm::length(sum);
    if (length > 0.0 && std::isfinite(length)) return glm::vec3(sum / length);
    ++unknown;
    return kUnknownNormal;
}

std::uint32_t apply_clusters(Mesh& mesh, Clusters& clusters, const std::vector<glm::dvec3>& area_vectors) {
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

}  // namespace

std::uint32_t make_smooth_normals(Mesh& mesh, float crease_angle_deg) {
    KREDA_EXPECT(crease_angle_deg >= 0.0f);
    const std::vector<glm::dvec3> area_vectors = all_area_vectors(mesh);
    const std::vector<std::uint32_t> point_of_vertex = weld_by_position(mesh.positions);
    const std::vector<Side> sides = sorted_sides(mesh, point_of_vertex, area_vectors);
    Clusters clusters(3 * std::size_t{mesh.triangle_count()});
    unite_over_smooth_edges(clusters, sides, area_vectors, double{crease_angle_deg});
    return apply_clusters(mesh, clusters, area_vectors);
}

namespace {

constexpr double kCreaseDeg = 60.0;
constexpr std::uint32_t kMostOfSpeck = 3;   // triangles
constexpr std::uint32_t kLeastAround = 16;  // times as many triangles as the speck
constexpr int kSpeckPasses = 3;             // specks that touch each other vanish one after the other

/// Smooth regions of triangles, and which triangles were joined to a region over a crease.
struct Regions {
    Clusters of_triangle;
    std::vector<std::uint32_t> size;  // at the triangle that names a region
    std::vector<bool> absorbed;

    explicit Regions(std::uint32_t triangles)
        : of_triangle(triangles), size(triangles, 0), absorbed(triangles, false) {}

    void count() {
        std::ranges::fill(size, 0u);
        for (std::uint32_t t = 0; t < size.size(); ++t) ++size[of_triangle.find(t)];
    }
};

bool is_edge(const std::vector<Side>& sides, std::size_t i) {
    return sides[i - 1].points == sides[i].points;
}

/// A small region and a neighbour, once for each edge between them, sorted.
std::vector<std::pair<std::uint32_t, std::uint32_t>> borders_of_small(Regions& regions,
                                                                      const std::vector<Side>& sides) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> borders;
    for (std::size_t i = 1; i < sides.size(); ++i) {
        if (!is_edge(sides, i)) continue;
        const std::uint32_t a = regions.of_triangle.find(sides[i - 1].low_corner / 3);
        const std::uint32_t b = regions.of_triangle.find(sides[i].low_corner / 3);
        if (a == b) continue;
        if (regions.size[a] <= kMostOfSpeck) borders.emplace_back(a, b);
        if (regions.size[b] <= kMostOfSpeck) borders.emplace_back(b, a);
    }
    std::ranges::sort(borders);
    return borders;
}

/// Join every speck to the large region that more than half of its edges border on.
void absorb_specks(Regions& regions, const std::vector<Side>& sides) {
    regions.count();
    const auto borders = borders_of_small(regions, sides);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> joined;
    for (std::size_t first = 0, end = 0; first < borders.size(); first = end) {
        while (end < borders.size() && borders[end].first == borders[first].first) ++end;
        std::size_t run = 0;
        for (std::size_t i = first; i < end; ++i) {
            run = i > first && borders[i] == borders[i - 1] ? run + 1 : 1;
            const bool is_large = regions.size[borders[i].second] >= kLeastAround * regions.size[borders[i].first];
            if (is_large && 2 * run > end - first) {
                joined.push_back(borders[i]);
                break;
            }
        }
    }
    std::vector<bool> is_speck(regions.size.size(), false);
    for (const auto& [speck, around] : joined) is_speck[speck] = true;
    for (std::uint32_t t = 0; t < is_speck.size(); ++t) {
        if (is_speck[regions.of_triangle.find(t)]) regions.absorbed[t] = true;
    }
    for (const auto& [speck, around] : joined) regions.of_triangle.unite(speck, around);
}

Regions find_regions(std::uint32_t triangles, const std::vector<Side>& sides,
                     const std::vector<glm::dvec3>& area_vectors) {
    Regions regions(triangles);
    for (std::size_t i = 1; i < sides.size(); ++i) {
        const std::uint32_t a = sides[i - 1].low_corner / 3, b = sides[i].low_corner / 3;
        if (is_edge(sides, i) && is_smooth_edge(area_vectors[a], area_vectors[b], kCreaseDeg)) {
            regions.of_triangle.unite(a, b);
        }
    }
    for (int pass = 0; pass < kSpeckPasses; ++pass) absorb_specks(regions, sides);
    return regions;
}

}  // namespace

std::uint32_t make_smooth_normals_without_specks(Mesh& mesh) {
    const std::vector<glm::dvec3> area_vectors = all_area_vectors(mesh);
    const std::vector<Side> sides = sorted_sides(mesh, weld_by_position(mesh.positions), area_vectors);
    Clusters clusters(3 * std::size_t{mesh.triangle_count()});
    unite_over_smooth_edges(clusters, sides, area_vectors, kCreaseDeg);
    Regions regions = find_regions(mesh.triangle_count(), sides, area_vectors);
    for (std::size_t i = 1; i < sides.size(); ++i) {
        const std::uint32_t a = sides[i - 1].low_corner / 3, b = sides[i].low_corner / 3;
        const bool is_speck_edge = is_edge(sides, i) && (regions.absorbed[a] || regions.absorbed[b]);
        if (!is_speck_edge || regions.of_triangle.find(a) != regions.of_triangle.find(b)) continue;
        clusters.unite(sides[i - 1].low_corner, sides[i].low_corner);
        clusters.unite(sides[i - 1].high_corner, sides[i].high_corner);
    }
    return apply_clusters(mesh, clusters, area_vectors);
}

std::uint32_t make_smooth_normals_by_group(Mesh& mesh, std::span<const std::uint32_t> smoothing_group_of_triangle) {
    KREDA_EXPECT(smoothing_group_of_triangle.size() == mesh.triangle_count());
    const std::vector<glm::dvec3> area_vectors = all_area_vectors(mesh);
    const std::vector<std::uint32_t> point_of_vertex = weld_by_position(mesh.positions);
    Clusters clusters(3 * std::size_t{mesh.triangle_count()});
    std::unordered_map<std::uint64_t, std::uint32_t> first_corner;  // (point, group) -> a corner of its cluster
    for (std::uint32_t corner = 0; corner < clusters.parent.size(); ++corner) {
        const std::uint32_t group = smoothing_group_of_triangle[corner / 3];
        if (group == 0 || is_degenerate(area_vectors[corner / 3])) continue;
        const std::uint64_t key = std::uint64_t{point_of_vertex[mesh.indices[corner]]} << 32 | group;
        clusters.unite(first_corner.try_emplace(key, corner).first->second, corner);
    }
    return apply_clusters(mesh, clusters, area_vectors);
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
