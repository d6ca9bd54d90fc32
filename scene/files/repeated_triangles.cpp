#include "scene/files/repeated_triangles.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "raster/mesh_checks.hpp"

namespace kreda::scene {

namespace {

/// The points of a triangle, the smallest first, and its number.
struct TurnedTriangle {
    std::array<std::uint32_t, 3> points;
    std::uint32_t triangle;
};

/// The triangles of a mesh by their points: vertices at bitwise equal positions are one.
struct PointTriangles {
    std::vector<std::uint32_t> point_of_vertex;
    const raster::Mesh& mesh;

    [[nodiscard]] TurnedTriangle at(std::uint32_t triangle) const {
        const std::uint32_t* v = &mesh.indices[3 * std::size_t{triangle}];
        const std::uint32_t points[3] = {point_of_vertex[v[0]], point_of_vertex[v[1]], point_of_vertex[v[2]]};
        const std::size_t first = static_cast<std::size_t>(std::min_element(points, points + 3) - points);
        return {{points[first], points[(first + 1) % 3], points[(first + 2) % 3]}, triangle};
    }
};

/// All triangles in the order of their smallest point: counted first, so that it takes no comparisons.
std::vector<TurnedTriangle> by_smallest_point(const PointTriangles& triangles, std::vector<std::uint32_t>& end) {
    const std::uint32_t count = triangles.mesh.triangle_count();
    end.assign(triangles.point_of_vertex.size() + 1, 0);
    for (std::uint32_t t = 0; t < count; ++t) ++end[std::size_t{triangles.at(t).points[0]} + 1];
    for (std::size_t p = 1; p < end.size(); ++p) end[p] += end[p - 1];
    std::vector<TurnedTriangle> sorted(count);
    for (std::uint32_t t = 0; t < count; ++t) {  // in the end, end[p] is where the triangles of point p end
        const TurnedTriangle triangle = triangles.at(t);
        sorted[end[triangle.points[0]]++] = triangle;
    }
    return sorted;
}

/// Where the part behind the one that holds a triangle stands in the list of parts.
std::size_t behind_part_of(const raster::Mesh& mesh, std::uint32_t triangle) {
    const auto begins_behind = [](std::uint32_t t, const raster::MeshPart& part) { return t < part.first_triangle; };
    const auto behind = std::upper_bound(mesh.parts.begin(), mesh.parts.end(), triangle, begins_behind);
    return static_cast<std::size_t>(behind - mesh.parts.begin());
}

/// For each triangle, whether one before it in its part has the same points.
std::vector<bool> repeated_triangles(const raster::Mesh& mesh) {
    std::vector<std::uint32_t> end;
    std::vector<TurnedTriangle> sorted = by_smallest_point({raster::weld_by_position(mesh.positions), mesh}, end);
    const auto is_before = [](const TurnedTriangle& a, const TurnedTriangle& b) {
        return a.points != b.points ? a.points < b.points : a.triangle < b.triangle;
    };
    std::vector<bool> is_repeated(sorted.size(), false);
    for (std::size_t p = 0; p + 1 < end.size(); ++p) {
        const std::uint32_t from = p == 0 ? 0 : end[p - 1];
        std::sort(sorted.begin() + from, sorted.begin() + end[p], is_before);
        for (std::uint32_t i = from + 1; i < end[p]; ++i) {
            const TurnedTriangle &before = sorted[i - 1], &triangle = sorted[i];
            is_repeated[triangle.triangle] =
                triangle.points == before.points &&
                behind_part_of(mesh, before.triangle) == behind_part_of(mesh, triangle.triangle);
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
