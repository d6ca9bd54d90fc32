#include "scene/files/repeated_triangles.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace kreda::scene {

namespace {

/// The vertices of a triangle, the smallest first, and its number.
struct TurnedTriangle {
    std::array<std::uint32_t, 3> vertices;
    std::uint32_t triangle;
};

TurnedTriangle turned(const raster::Mesh& mesh, std::uint32_t triangle) {
    const std::uint32_t* v = &mesh.indices[3 * std::size_t{triangle}];
    const std::size_t first = static_cast<std::size_t>(std::min_element(v, v + 3) - v);
    return {{v[first], v[(first + 1) % 3], v[(first + 2) % 3]}, triangle};
}

/// All triangles in the order of their smallest vertex: counted first, so that it takes no comparisons.
std::vector<TurnedTriangle> by_smallest_vertex(const raster::Mesh& mesh, std::vector<std::uint32_t>& end) {
    const std::uint32_t count = mesh.triangle_count();
    end.assign(mesh.positions.size() + 1, 0);
    for (std::uint32_t t = 0; t < count; ++t) ++end[std::size_t{turned(mesh, t).vertices[0]} + 1];
    for (std::size_t v = 1; v < end.size(); ++v) end[v] += end[v - 1];
    std::vector<TurnedTriangle> sorted(count);
    for (std::uint32_t t = 0; t < count; ++t) {  // in the end, end[v] is where the triangles of vertex v end
        const TurnedTriangle triangle = turned(mesh, t);
        sorted[end[triangle.vertices[0]]++] = triangle;
    }
    return sorted;
}

/// For each triangle, whether one before it has the same vertices.
std::vector<bool> repeated_triangles(const raster::Mesh& mesh) {
    std::vector<std::uint32_t> end;
    std::vector<TurnedTriangle> sorted = by_smallest_vertex(mesh, end);
    const auto is_before = [](const TurnedTriangle& a, const TurnedTriangle& b) {
        return a.vertices != b.vertices ? a.vertices < b.vertices : a.triangle < b.triangle;
    };
    std::vector<bool> is_repeated(sorted.size(), false);
    for (std::size_t v = 0; v + 1 < end.size(); ++v) {
        const std::uint32_t from = v == 0 ? 0 : end[v - 1];
        std::sort(sorted.begin() + from, sorted.begin() + end[v], is_before);
        for (std::uint32_t i = from + 1; i < end[v]; ++i) {
            is_repeated[sorted[i].triangle] = sorted[i].vertices == sorted[i - 1].vertices;
        }
    }
    return is_repeated;
}

}  // namespace

std::size_t drop_repeated_triangles(raster::Mesh& mesh) {
    const std::vector<bool> is_repeated = repeated_triangles(mesh);
    if (std::find(is_repeated.begin(), is_repeated.end(), true) == is_repeated.end()) return 0;
    std::uint32_t kept = 0;
    for (raster::MeshPart& part : mesh.parts) {
        const std::uint32_t first = part.first_triangle, end = first + part.triangle_count;
        part.first_triangle = kept;
        for (std::uint32_t t = first; t < end; ++t) {
            if (is_repeated[t]) continue;
            std::copy_n(&mesh.indices[3 * std::size_t{t}], 3, &mesh.indices[3 * std::size_t{kept}]);
            ++kept;
        }
        part.triangle_count = kept - part.first_triangle;
    }
    mesh.indices.resize(3 * std::size_t{kept});
    return is_repeated.size() - kept;
}

std::string warning_of_repeated(std::size_t triangles, const std::string& file) {
    if (triangles == 0) return "";
    const std::string what = triangles == 1 ? " triangle has" : " triangles have";
    return file + ": " + std::to_string(triangles) + what + " the corners of one before; each is drawn once";
}

}  // namespace kreda::scene
