// The checker itself, on meshes small enough to count by hand.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "raster/mesh_checks.hpp"

using namespace kreda::raster;

namespace {

/// Corner at the origin, edges 1 along the axes: volume 1/6, area 3/2 + sqrt(3)/2.
Mesh tetrahedron() {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.indices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    return mesh;
}

}  // namespace

TEST_CASE("mesh checks: a tetrahedron by hand") {
    const MeshReport report = check_mesh(tetrahedron());
    CHECK(report.points == 4);
    CHECK(report.edges == 6);
    CHECK(report.faces == 4);
    CHECK(report.is_closed());
    CHECK(report.euler_characteristic() == 2);
    CHECK(report.signed_volume == doctest::Approx(1.0 / 6.0));
    CHECK(report.area == doctest::Approx(1.5 + std::sqrt(3.0) / 2));
    CHECK(report.bounds_min == glm::vec3(0.0f));
    CHECK(report.bounds_max == glm::vec3(1.0f));
}

TEST_CASE("mesh checks: turning all triangles around negates the volume and moving the mesh keeps it") {
    Mesh turned = tetrahedron();
    for (std::size_t i = 0; i < turned.indices.size(); i += 3) std::swap(turned.indices[i], turned.indices[i + 1]);
    CHECK(check_mesh(turned).signed_volume == doctest::Approx(-1.0 / 6.0));
    Mesh moved = tetrahedron();
    for (glm::vec3& p : moved.positions) p += glm::vec3(4.0f, -8.0f, 16.0f);  // exact in float
    CHECK(check_mesh(moved).signed_volume == doctest::Approx(1.0 / 6.0));
}

TEST_CASE("mesh checks: each defect is counted as what it is") {
    Mesh open = tetrahedron();
    open.indices.resize(9);
    CHECK(check_mesh(open).open_edges == 3);

    Mesh flipped = tetrahedron();
    std::swap(flipped.indices[0], flipped.indices[1]);
    CHECK(check_mesh(flipped).flipped_edges == 3);
    CHECK(check_mesh(flipped).open_edges == 0);

    Mesh fin = tetrahedron();
    fin.positions.emplace_back(2.0f, 2.0f, 2.0f);
    fin.indices.insert(fin.indices.end(), {0, 1, 4});
    CHECK(check_mesh(fin).non_manifold_edges == 1);
    CHECK(check_mesh(fin).open_edges == 2);

    Mesh bad = tetrahedron();
    bad.indices.insert(bad.indices.end(), {0, 1, 9});
    CHECK(check_mesh(bad).bad_triangles == 1);
    CHECK(check_mesh(bad).is_closed());

    Mesh broken = tetrahedron();
    broken.positions[3].y = std::numeric_limits<float>::quiet_NaN();
    CHECK(check_mesh(broken).non_finite_vertices == 1);
    CHECK(check_mesh(broken).degenerate_triangles == 3);
    CHECK(check_mesh(broken).area == doctest::Approx(0.5));
    CHECK(check_mesh(broken).bounds_max == glm::vec3(1.0f, 1.0f, 0.0f));
}

TEST_CASE("mesh checks: collapsed and collinear triangles are degenerate and collapsed ones have no edges") {
    Mesh mesh = tetrahedron();
    mesh.positions.emplace_back(0.5f, 0.0f, 0.0f);
    mesh.indices.insert(mesh.indices.end(), {0, 0, 1});
    CHECK(check_mesh(mesh).degenerate_triangles == 1);
    CHECK(check_mesh(mesh).is_closed());
    mesh.indices.insert(mesh.indices.end(), {0, 4, 1});
    CHECK(check_mesh(mesh).degenerate_triangles == 2);
    CHECK_FALSE(check_mesh(mesh).is_closed());
}

TEST_CASE("mesh checks: area vectors do not lose tiny triangles") {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1e-25f, 0, 0}, {0, 1e-25f, 0}};
    mesh.indices = {0, 1, 2};
    // 1e-50 is no float. Approx is absolute near zero, so compare the quotient; 1e-6: 1e-25 is rounded to float.
    CHECK(twice_area_vector(mesh, 0).z / 1e-50 == doctest::Approx(1.0).epsilon(1e-6));
    CHECK(check_mesh(mesh).degenerate_triangles == 0);
}

TEST_CASE("mesh checks: collinear points have no area at any scale") {
    Mesh mesh;
    mesh.indices = {0, 1, 2};
    for (const float scale : {1e-30f, 1.0f, 1e30f}) {
        const glm::vec3 step = scale * glm::vec3(0.1f, 0.7f, -0.3f);
        mesh.positions = {-step, step, 4.0f * step};  // exact: powers of two
        CHECK(check_mesh(mesh).degenerate_triangles == 1);
    }
}

TEST_CASE("weld: equal positions are one point and both zeros are equal") {
    const std::vector<glm::vec3> positions = {{1, 2, 3}, {0.0f, 0, 0}, {1, 2, 3}, {-0.0f, 0, -0.0f}, {3, 2, 1}};
    CHECK(weld_by_position(positions) == std::vector<std::uint32_t>{0, 1, 0, 1, 2});
    CHECK(weld_by_position({}).empty());
}
