#include "raster/tangents.hpp"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "raster/platform.hpp"

namespace kreda::raster {

namespace {

/// The unit vector along v, or 0 if v has no length.
glm::dvec3 direction_of(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? v / length : glm::dvec3(0.0);
}

/// The tangent that follows from one triangle: the direction of dP/du, and whether uv runs clockwise on it. 0: its uvs
/// lie on a line, so nothing follows.
struct TriangleTangent {
    glm::dvec3 direction{0.0};
    int side = 0;  ///< +1, -1 mirrored, 0 nothing
};

TriangleTangent tangent_of(const Mesh& mesh, const std::uint32_t* corner) {
    const glm::dvec3 p(mesh.positions[corner[0]]);
    const glm::dvec2 uv(mesh.uvs[corner[0]]);
    const glm::dvec3 e1 = glm::dvec3(mesh.positions[corner[1]]) - p;
    const glm::dvec3 e2 = glm::dvec3(mesh.positions[corner[2]]) - p;
    const glm::dvec2 d1 = glm::dvec2(mesh.uvs[corner[1]]) - uv;
    const glm::dvec2 d2 = glm::dvec2(mesh.uvs[corner[2]]) - uv;
    const double area = d1.x * d2.y - d2.x * d1.y;  // exact zero for repeated uvs; a sliver of rounding is no picture
    const double least = 1e-12 * (glm::dot(d1, d1) + glm::dot(d2, d2));
    if (!(std::abs(area) > least)) return {};
    const double side = area > 0.0 ? 1.0 : -1.0;
    const glm::dvec3 direction = direction_of((e1 * d2.y - e2 * d1.y) * side);
    if (direction == glm::dvec3(0.0)) return {};
    return {direction, area > 0.0 ? 1 : -1};
}

/// The angle between two edges; 0 if one of them has no length.
double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// v without its part along n.
glm::dvec3 in_plane(const glm::dvec3& v, const glm::dvec3& n) {
    return v - n * glm::dot(n, v);
}

/// Sums over the triangles at a vertex, the mirrored ones apart.
struct Sums {
    std::array<glm::dvec3, 2> direction{glm::dvec3(0.0), glm::dvec3(0.0)};  ///< side +1, side -1
    std::array<bool, 2> used{false, false};
    bool in_use = false;  ///< by some triangle, even one that says nothing
};

void add_triangle(const Mesh& mesh, const std::uint32_t* corner, const TriangleTangent& tangent,
                  std::vector<Sums>& sums) {
    const std::size_t side = tangent.side > 0 ? 0 : 1;
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t vertex = corner[i];
        const glm::dvec3 p(mesh.positions[vertex]);
        const glm::dvec3 a = glm::dvec3(mesh.positions[corner[(i + 1) % 3]]) - p;
        const glm::dvec3 b = glm::dvec3(mesh.positions[corner[(i + 2) % 3]]) - p;
        const glm::dvec3 flat = direction_of(in_plane(tangent.direction, glm::dvec3(mesh.normals[vertex])));
        sums[vertex].direction[side] += flat * angle_between(a, b);
        sums[vertex].used[side] = true;
    }
}

/// A second vertex for the mirrored triangles.
std::uint32_t copy_vertex(Mesh& mesh, std::uint32_t vertex) {
    const glm::vec3 position = mesh.positions[vertex];
    const glm::vec3 normal = mesh.normals[vertex];
    const glm::vec2 uv = mesh.uvs[vertex];
    mesh.positions.push_back(position);
    mesh.normals.push_back(normal);
    mesh.uvs.push_back(uv);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

/// side: 0 for unmirrored triangles, 1 for mirrored ones.
glm::vec4 vertex_tangent(const Sums& sums, std::size_t side, const glm::vec3& normal, TangentReport& report) {
    const glm::dvec3 n(normal);
    const glm::dvec3 t = direction_of(in_plane(sums.direction[side], n));
    if (t != glm::dvec3(0.0)) return {glm::vec3(t), side == 0 ? 1.0f : -1.0f};
    report.without_direction += sums.in_use;
    return {glm::vec3(any_perpendicular(n)), 1.0f};
}

/// Sorts vertices by their first use, those without a use at the end: no part's vertices lie among those of
/// another part that way, although copies were appended.
void sort_by_first_use(Mesh& mesh) {
    constexpr std::uint32_t kNone = 0xffffffffu;
    std::vector<std::uint32_t> new_of(mesh.positions.size(), kNone);
    std::vector<std::uint32_t> old_of;
    const auto take = [&](std::uint32_t vertex) {
        if (new_of[vertex] != kNone) return;
        new_of[vertex] = static_cast<std::uint32_t>(old_of.size());
        old_of.push_back(vertex);
    };
    for (const std::uint32_t vertex : mesh.indices) take(vertex);
    for (std::uint32_t vertex = 0; vertex < mesh.positions.size(); ++vertex) take(vertex);
    const Mesh source = mesh;
    for (std::size_t i = 0; i < old_of.size(); ++i) {
        mesh.positions[i] = source.positions[old_of[i]];
        mesh.normals[i] = source.normals[old_of[i]];
        mesh.uvs[i] = source.uvs[old_of[i]];
        mesh.tangents[i] = source.tangents[old_of[i]];
    }
    for (std::uint32_t& index : mesh.indices) index = new_of[index];
}

}  // namespace

glm::dvec3 any_perpendicular(const glm::dvec3& n) {
    const glm::dvec3 a = glm::abs(n);
    if (a.x <= a.y && a.x <= a.z) {
        const glm::dvec3 t = direction_of(in_plane(glm::dvec3(1.0, 0.0, 0.0), n));
        return t == glm::dvec3(0.0) ? glm::dvec3(1.0, 0.0, 0.0) : t;
    }
    return direction_of(in_plane(a.y <= a.z ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0), n));
}

TangentReport make_tangents(Mesh& mesh) {
    KREDA_EXPECT(mesh.uvs.size() == mesh.positions.size() && mesh.normals.size() == mesh.positions.size());
    TangentReport report;
    const std::size_t triangles = mesh.triangle_count();
    const std::size_t vertices = mesh.positions.size();
    std::vector<TriangleTangent> of_triangle(triangles);
    std::vector<Sums> sums(vertices);
    for (std::size_t t = 0; t < triangles; ++t) {
        of_triangle[t] = tangent_of(mesh, &mesh.indices[3 * t]);
        for (int i = 0; i < 3; ++i) sums[mesh.indices[3 * t + i]].in_use = true;
        if (of_triangle[t].side == 0) ++report.degenerate_triangles;
        if (of_triangle[t].side != 0) add_triangle(mesh, &mesh.indices[3 * t], of_triangle[t], sums);
    }
    std::vector<std::uint32_t> mirrored(vertices);  // the vertex that mirrored triangles use instead
    mesh.tangents.assign(vertices, glm::vec4(0.0f));
    for (std::uint32_t v = 0; v < vertices; ++v) {
        const Sums& sum = sums[v];
        const bool split = sum.used[0] && sum.used[1];
        const std::size_t side = sum.used[1] && !split ? 1 : 0;
        mesh.tangents[v] = vertex_tangent(sum, side, mesh.normals[v], report);
        mirrored[v] = split ? copy_vertex(mesh, v) : v;
        if (!split) continue;
        ++report.split_vertices;
        mesh.tangents.resize(mesh.positions.size());
        mesh.tangents.back() = vertex_tangent(sum, 1, mesh.normals[v], report);
    }
    for (std::size_t t = 0; t < triangles; ++t) {
        if (of_triangle[t].side >= 0) continue;
        for (std::size_t i = 3 * t; i < 3 * t + 3; ++i) mesh.indices[i] = mirrored[mesh.indices[i]];
    }
    if (report.split_vertices > 0) sort_by_first_use(mesh);
    return report;
}

}  // namespace kreda::raster
