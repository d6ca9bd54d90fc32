// Normals of meshes without normals: the noise of a scanner leaves no specks, and flat objects stay crisp.
#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include "raster/mesh_checks.hpp"
#include "raster/normals.hpp"
#include "raster/shapes.hpp"
#include "welded_mesh.hpp"

using namespace kreda::raster;

namespace {

/// A scan of the unit sphere: a few single points slid along the surface by one and a half edges, so that triangles
/// around them fold over and face inwards.
Mesh noisy_scan() {
    constexpr int kDetail = 48;
    Mesh mesh = welded(make_sphere(kDetail));
    std::mt19937 bits(7);
    const float edge = 2.0f * 3.14159265f / float(kDetail);
    for (std::size_t i = 20; i + 20 < mesh.positions.size(); i += 61 + bits() % 20) {
        glm::vec3& p = mesh.positions[i];
        if (std::abs(p.y) > 0.8f) continue;  // edges are shorter near the poles
        const glm::vec3 east = glm::normalize(glm::vec3(p.z, 0.0f, -p.x));
        p = glm::normalize(p + 1.5f * edge * east);
    }
    return mesh;
}

/// Largest angle between the normal at a corner and the sphere's, degrees.
double worst_tilt(const Mesh& mesh) {
    double least = 1.0;
    for (const std::uint32_t v : mesh.indices) {
        least = std::min(least, glm::dot(glm::dvec3(mesh.normals[v]), glm::normalize(glm::dvec3(mesh.positions[v]))));
    }
    return glm::degrees(std::acos(least));
}

/// Corners of a regular polygon, the first `corners` of them.
std::vector<glm::dvec2> outline(int sides, int corners) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = 6.283185307179586 * i / sides;
        points.emplace_back(std::cos(angle), std::sin(angle));
    }
    return points;
}

/// An upright prism, its walls cut into `rows`; caps are fans around their first corner, as programs write them.
Mesh prism(const std::vector<glm::dvec2>& points, int rows) {
    const int sides = static_cast<int>(points.size());
    Mesh mesh;
    for (int row = 0; row <= rows; ++row) {
        for (const glm::dvec2& p : points) mesh.positions.emplace_back(p.x, 2.0 * row / rows, p.y);
    }
    const auto at = [&](int row, int i) { return static_cast<std::uint32_t>(row * sides + i % sides); };
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < sides; ++i) {
            const std::uint32_t a = at(row, i), b = at(row, i + 1), c = at(row + 1, i + 1), d = at(row + 1, i);
            mesh.indices.insert(mesh.indices.end(), {a, d, c, a, c, b});
        }
    }
    for (int i = 1; i + 1 < sides; ++i) {
        mesh.indices.insert(mesh.indices.end(), {at(0, 0), at(0, i), at(0, i + 1)});
        mesh.indices.insert(mesh.indices.end(), {at(rows, 0), at(rows, i + 1), at(rows, i)});
    }
    return mesh;
}

/// The default keeps every edge that a crease of 60 degrees keeps.
bool is_as_crisp_as_the_crease(const Mesh& mesh) {
    Mesh by_default = mesh, by_crease = mesh;
    make_smooth_normals_without_specks(by_default);
    make_smooth_normals(by_crease, 60.0f);
    return by_default.normals == by_crease.normals && by_default.indices == by_crease.indices;
}

}  // namespace

TEST_CASE("specks: folded triangles of a scan are lit with the surface around them") {
    Mesh creased = noisy_scan(), smooth = noisy_scan(), healed = noisy_scan();
    make_smooth_normals(creased, 60.0f);
    make_smooth_normals(smooth, 180.0f);
    make_smooth_normals_without_specks(healed);
    CHECK(worst_tilt(creased) > 120.0);  // black under a lamp at the camera
    CHECK(worst_tilt(healed) < 60.0);
    CHECK(worst_tilt(healed) == worst_tilt(smooth));  // nothing but the folds is sharp there
}

TEST_CASE("specks: cubes, prisms and their caps keep their edges") {
    CHECK(is_as_crisp_as_the_crease(welded(make_cube(1))));
    CHECK(is_as_crisp_as_the_crease(welded(make_cube(20))));  // faces of 2 x 400 triangles
    for (const int sides : {3, 4, 5, 6, 7, 12, 64}) {
        for (const int rows : {1, 40}) {
            CAPTURE(sides);
            CAPTURE(rows);
            CHECK(is_as_crisp_as_the_crease(prism(outline(sides, sides), rows)));
        }
    }
}

TEST_CASE("specks: half a prism, whose cap has more than half of its edges at one smooth wall, keeps them") {
    CHECK(is_as_crisp_as_the_crease(prism(outline(6, 4), 1)));  // a cap of 2 triangles, a wall of 6
    CHECK(is_as_crisp_as_the_crease(prism(outline(6, 4), 4)));
}

TEST_CASE("specks: a small box on a large floor keeps its edges, a fold of the floor does not") {
    Mesh mesh = welded(make_plane(30));
    const auto floor = static_cast<std::uint32_t>(mesh.triangle_count());
    const Mesh box = welded(make_cube(1));
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3& p : box.positions) mesh.positions.push_back(0.02f * p);
    for (const std::uint32_t index : box.indices) mesh.indices.push_back(first + index);
    CHECK(is_as_crisp_as_the_crease(mesh));

    // One corner of the floor, moved over its neighbour to the right and up: the triangles that fold over become part
    // of the floor, whose normals stay near +y.
    mesh.positions[15 * 31 + 15] += glm::vec3(2.5f / 15.0f, 0.01f, 0.0f);
    Mesh creased = mesh;
    make_smooth_normals(creased, 60.0f);
    make_smooth_normals_without_specks(mesh);
    float lowest = 1.0f, lowest_creased = 1.0f;
    for (std::uint32_t c = 0; c < 3 * floor; ++c) {
        lowest = std::min(lowest, mesh.normals[mesh.indices[c]].y);
        lowest_creased = std::min(lowest_creased, creased.normals[creased.indices[c]].y);
    }
    CHECK(lowest_creased < -0.5f);
    CHECK(lowest > 0.5f);
}
