// Laws about the meshes of 15_mesh.
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "course.hpp"
#include "raster/mesh_checks.hpp"
#include "raster/normals.hpp"
#include "raster/shapes.hpp"
#include "scene/files/mesh_file.hpp"

using namespace kreda;
using namespace kreda::tests;

TEST_CASE("15 mesh: the gem is closed and Euler's formula holds") {
    const raster::Mesh gem = scene::load_mesh_file(std::string(KREDA_SOURCE_DIR) + "/examples/15_mesh/gem.obj").mesh;
    const raster::MeshReport report = check_mesh(gem);
    CHECK(gem.triangle_count() == documented_number("15_mesh", "gem_triangles"));
    CHECK(report.is_closed());
    CHECK(report.euler_characteristic() == 2);
    // An icosahedron of edge 2: 5/12 (3 + sqrt 5) 8, positive because the faces look outward.
    CHECK(report.signed_volume == doctest::Approx(10.0 / 3.0 * (3.0 + std::sqrt(5.0))).epsilon(1e-6));
}

TEST_CASE("15 mesh: by symmetry the gem's smooth normals point along its corners") {
    raster::Mesh gem = scene::load_mesh_file(std::string(KREDA_SOURCE_DIR) + "/examples/15_mesh/gem.obj").mesh;
    make_smooth_normals(gem, 60.0f);
    for (std::size_t i = 0; i < gem.positions.size(); ++i) {
        const float cosine = glm::dot(gem.normals[i], glm::normalize(gem.positions[i]));
        CHECK(cosine == doctest::Approx(1.0).epsilon(1e-6));  // 1.618034 in the file is rounded to seven digits
    }
}

TEST_CASE("15 mesh: the teapot has the number of triangles on the page") {
    CHECK(raster::make_teapot(3).triangle_count() == documented_number("15_mesh", "teapot_triangles"));
}

TEST_CASE("15 mesh: in the picture flat normals are few colours and each is a unit vector") {
    const raster::Image picture = golden_montage("15_mesh/normals", 3);
    int covered = 0;
    for (int y = 10; y < 60; ++y) {
        for (int x = 120; x < 200; ++x) {  // inside the panel with the gem's flat normals
            const glm::vec3 color = picture.rgb(x, y);
            const glm::vec3 board(0x20 / 255.0f, 0x26 / 255.0f, 0x2b / 255.0f);
            if (glm::distance(color, board) < 0.01f) continue;
            ++covered;
            // Each of the three bytes is off by at most half a step, 1/255 of 2.
            CHECK(glm::length(2.0f * color - 1.0f) == doctest::Approx(1.0).epsilon(1.8 / 255.0));
        }
    }
    CHECK(covered > 1000);
}
