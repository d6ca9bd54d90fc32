// Normals from positions: hand-worked weights, creases by counting, and the analytic normals of the built-in shapes.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "raster/mesh_checks.hpp"
#include "raster/normals.hpp"
#include "raster/shapes.hpp"
#include "welded_mesh.hpp"

using namespace kreda::raster;

namespace {

/// The roof: triangle A = (0,0,0) (1,0,0) (0,1,0) in the xy plane and B = (0,0,0) (0,0,3) (1,0,0) in the xz plane,
/// joined at right angles along the x axis.
Mesh roof() {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 3}};
    mesh.indices = {0, 1, 2, 0, 3, 1};
    return mesh;
}

double largest_difference(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, glm::length(glm::dvec3(a[i]) - glm::dvec3(b[i])));
    }
    return largest;
}

}  // namespace

TEST_CASE("smooth normals: triangles weigh by their area") {
    // A: (1,0,0) x (0,1,0) = (0,0,1). B: (0,0,3) x (1,0,0) = (0,3,0). The sum (0,3,1) has the length sqrt 10.
    Mesh mesh = roof();
    CHECK(make_smooth_normals(mesh, 180.0f) == 0);
    REQUIRE(mesh.normals.size() == 4);
    const glm::vec3 shared(0.0f, 3.0f / std::sqrt(10.0f), 1.0f / std::sqrt(10.0f));
    CHECK(glm::length(mesh.normals[0] - shared) < 1e-7f);  // a float ulp of 1
    CHECK(glm::length(mesh.normals[1] - shared) < 1e-7f);
    CHECK(mesh.normals[2] == glm::vec3(0, 0, 1));
    CHECK(mesh.normals[3] == glm::vec3(0, 1, 0));
}

TEST_CASE("smooth normals: an edge sharper than the crease angle splits its vertices and uvs follow") {
    Mesh mesh = roof();
    mesh.uvs = {{0.1f, 0.2f}, {0.3f, 0.4f}, {0.5f, 0.6f}, {0.7f, 0.8f}};
    make_smooth_normals(mesh, 89.0f);
    REQUIRE(mesh.positions.size() == 6);
    CHECK(mesh.indices == std::vector<std::uint32_t>{0, 1, 2, 4, 3, 5});
    CHECK(mesh.positions[4] == mesh.positions[0]);
    CHECK(mesh.positions[5] == mesh.positions[1]);
    CHECK(mesh.uvs[4] == glm::vec2(0.1f, 0.2f));
    CHECK(mesh.uvs[5] == glm::vec2(0.3f, 0.4f));
    CHECK(mesh.normals[0] == glm::vec3(0, 0, 1));
    CHECK(mesh.normals[4] == glm::vec3(0, 1, 0));
    Mesh exact = roof();
    make_smooth_normals(exact, 90.0f);  // 90 does not exceed 90
    CHECK(exact.positions.size() == 4);
}

TEST_CASE("smooth normals: a cube has 24 normals at 60 degrees and 8 at 180") {
    Mesh sharp = welded(make_cube(1));
    REQUIRE(sharp.positions.size() == 8);
    make_smooth_normals(sharp, 60.0f);
    CHECK(sharp.positions.size() == 24);
    for (const glm::vec3 n : sharp.normals) CHECK(std::abs(n.x) + std::abs(n.y) + std::abs(n.z) == 1.0f);

    Mesh round = welded(make_cube(1));
    make_smooth_normals(round, 180.0f);
    CHECK(round.positions.size() == 8);
    for (std::size_t i = 0; i < 8; ++i) {
        CHECK(glm::dot(round.normals[i], round.positions[i]) > 0.0f);
        const glm::vec3 n = glm::abs(round.normals[i]);
        CHECK(std::min({n.x, n.y, n.z}) > 0.3f);  // a corner's three faces weigh (1, 1, 1) to (2, 2, 1): 1/3 at least
    }

    Mesh seams = make_cube(1);  // its 24 vertices stay, but hold 8 different normals
    make_smooth_normals(seams, 180.0f);
    CHECK(seams.positions.size() == 24);
    const std::vector<std::uint32_t> kinds = weld_by_position(seams.normals);
    CHECK(*std::ranges::max_element(kinds) + 1 == 8);
}

TEST_CASE("smooth normals: the analytic normals of a sphere and a torus come back") {
    for (const char* name : {"sphere", "torus", "torus_knot"}) {
        CAPTURE(name);
        const Mesh analytic = make_shape(name, 256).value();
        Mesh mesh = analytic;
        CHECK(make_smooth_normals(mesh) == 0);
        CHECK(mesh.indices == analytic.indices);  // nothing is sharp: no vertex was split
        // The error falls with the step; measured 0.0041, 0.0002, 0.0029 (the sphere's at the fans next to its poles).
        CHECK(largest_difference(mesh.normals, analytic.normals) < 0.01);
    }
}

TEST_CASE("smooth normals: vertices at one position get one normal across a uv seam") {
    Mesh mesh = make_sphere(16);
    make_smooth_normals(mesh, 180.0f);
    const std::vector<std::uint32_t> points = weld_by_position(mesh.positions);
    std::vector<glm::vec3> normal_of_point(points.size(), glm::vec3(0.0f));
    for (std::size_t i = 0; i < points.size(); ++i) {
        glm::vec3& normal = normal_of_point[points[i]];
        if (normal == glm::vec3(0.0f)) normal = mesh.normals[i];
        CHECK(normal == mesh.normals[i]);
    }
}

TEST_CASE("smooth normals: a point between two creases is cut into its two sides") {
    // Four triangles around the origin, folded by 90 degrees along the y axis: left pair faces +x, right pair faces +z.
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0, -1, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
    make_smooth_normals(mesh, 60.0f);
    CHECK(mesh.positions.size() == 5 + 3);  // the origin and both ends of the fold
    CHECK(mesh.normals[mesh.indices[0]] == glm::vec3(0, 0, 1));
    CHECK(mesh.indices[0] == mesh.indices[9]);
    CHECK(mesh.indices[3] == mesh.indices[6]);
    CHECK(mesh.indices[0] != mesh.indices[3]);
}

TEST_CASE("smooth normals: degenerate triangles contribute nothing and never make NaN") {
    Mesh mesh = roof();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    mesh.positions.insert(mesh.positions.end(), {{0.5f, 0, 0}, {nan, 0, 0}, {5, 5, 5}});
    mesh.indices.insert(mesh.indices.end(), {0, 4, 1, 0, 0, 1, 0, 1, 5});
    CHECK(make_smooth_normals(mesh, 180.0f) == 3);  // the point on the edge, the NaN and the unused vertex
    CHECK(mesh.positions.size() == 7);
    for (const std::size_t i : {4u, 5u, 6u}) CHECK(mesh.normals[i] == glm::vec3(0, 1, 0));
    CHECK(glm::length(mesh.normals[0] - glm::vec3(0.0f, 3.0f / std::sqrt(10.0f), 1.0f / std::sqrt(10.0f))) < 1e-7f);

    Mesh sheet;  // two opposite triangles: nothing is left of their sum at 180 degrees
    sheet.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    sheet.indices = {0, 1, 2, 0, 2, 1};
    CHECK(make_smooth_normals(sheet, 180.0f) == 3);
    CHECK(make_smooth_normals(sheet, 200.0f) == 3);
    CHECK(make_smooth_normals(sheet, 60.0f) == 0);
    CHECK(sheet.positions.size() == 6);
}

TEST_CASE("smooth normals: a vertex of degenerate triangles only borrows the normal of its point") {
    Mesh mesh = roof();
    mesh.positions.push_back(mesh.positions[2]);
    mesh.indices.insert(mesh.indices.end(), {4, 4, 2});
    CHECK(make_smooth_normals(mesh, 180.0f) == 0);
    CHECK(mesh.normals[4] == glm::vec3(0, 0, 1));
}

TEST_CASE("smoothing groups: equal groups are summed and group 0 is flat") {
    const std::vector<std::uint32_t> same = {7, 7}, different = {1, 2}, flat = {0, 0};
    Mesh mesh = roof();
    CHECK(make_smooth_normals_by_group(mesh, same) == 0);
    CHECK(mesh.positions.size() == 4);
    CHECK(glm::length(mesh.normals[0] - glm::vec3(0.0f, 3.0f / std::sqrt(10.0f), 1.0f / std::sqrt(10.0f))) < 1e-7f);
    for (const auto& groups : {different, flat}) {
        Mesh split = roof();
        make_smooth_normals_by_group(split, groups);
        CHECK(split.positions.size() == 6);
        CHECK(split.normals[split.indices[0]] == glm::vec3(0, 0, 1));
        CHECK(split.normals[split.indices[3]] == glm::vec3(0, 1, 0));
    }
    // Group 0 is flat even in a plane: a quad gets its two shared vertices twice.
    Mesh plane = welded(make_plane(1));
    make_smooth_normals_by_group(plane, flat);
    CHECK(plane.positions.size() == 6);
}

TEST_CASE("flat normals: three own vertices a triangle with the normal of its plane") {
    Mesh mesh = make_sphere(12);
    const Mesh source = mesh;
    CHECK(make_flat_normals(mesh) == 0);
    CHECK(mesh.positions.size() == 3 * source.triangle_count());
    CHECK(mesh.uvs.size() == mesh.positions.size());
    CHECK(mesh.parts.size() == source.parts.size());
    for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        const glm::dvec3 face = glm::normalize(twice_area_vector(source, t));
        for (std::uint32_t c = 3 * t; c < 3 * t + 3; ++c) {
            CHECK(mesh.indices[c] == c);
            CHECK(mesh.positions[c] == source.positions[source.indices[c]]);
            CHECK(mesh.uvs[c] == source.uvs[source.indices[c]]);
            CHECK(glm::length(glm::dvec3(mesh.normals[c]) - face) < 1e-7);  // rounded to float
        }
    }
    Mesh point;
    point.positions = {{1, 2, 3}};
    point.indices = {0, 0, 0};
    CHECK(make_flat_normals(point) == 3);
    CHECK(point.normals == std::vector<glm::vec3>(3, glm::vec3(0, 1, 0)));
}

TEST_CASE("normals: 0 degrees on a faceted sphere is flat shading with shared planes") {
    Mesh smooth = welded(make_sphere(12));
    make_smooth_normals(smooth, 0.0f);
    Mesh flat = welded(make_sphere(12));
    make_flat_normals(flat);
    for (std::size_t c = 0; c < flat.indices.size(); ++c) {
        // The quads of a sphere are plane trapezoids: their two triangles have one normal up to rounding of positions.
        CHECK(glm::length(smooth.normals[smooth.indices[c]] - flat.normals[c]) < 2e-6f);
    }
}

TEST_CASE("normals: an empty mesh stays empty") {
    Mesh mesh;
    CHECK(make_smooth_normals(mesh) == 0);
    CHECK(make_smooth_normals_by_group(mesh, {}) == 0);
    CHECK(make_flat_normals(mesh) == 0);
    CHECK(mesh.positions.empty());
}
