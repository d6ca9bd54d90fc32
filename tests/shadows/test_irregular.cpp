// The irregular z-buffer against rays: another predicate, another order, the same answer at every visible sample.
#include <doctest/doctest.h>

#include "hard_cases.hpp"
#include "shadows/compare.hpp"
#include "shadows/exact.hpp"
#include "shadows/irregular.hpp"

using namespace kreda;
using namespace kreda::shadows;
using namespace kreda::tests;

namespace {

std::vector<float> exact_factors(const ShadowScene& scene) {
    std::vector<float> factors(scene.sample_count(), 1.0f);
    exact_shadow(build_exact_shadow(scene.occluders, scene.light), scene.frame.samples(), factors);
    return factors;
}

std::vector<float> irregular_factors(const ShadowScene& scene) {
    std::vector<float> factors(scene.sample_count());
    irregular_shadow(scene.occluders, scene.light, scene.frame.samples(), factors);
    return factors;
}

}  // namespace

TEST_CASE("irregular z-buffer: every sample as the ray says - in every hard case") {
    for (const HardCase& hard_case : hard_cases()) {
        ShadowScene scene;
        hard_case.build(scene);
        scene.draw();
        const std::vector<float> exact = exact_factors(scene);
        const ShadowError error = compare_shadows(scene.frame.samples(), exact, irregular_factors(scene), 1);
        CAPTURE(hard_case.name);
        CHECK(error.visible > 1000);
        // Both round in double: they could differ only within 1e-12 of an edge, and no sample here lies so near.
        CHECK(error.misclassified() == 0);
        // There is a shadow to agree about. Only who looks from where the light is sees none.
        CHECK((error.edge_length > 10.0) == !hard_case.looks_along_light);
    }
}

TEST_CASE("irregular z-buffer: a thousand random scenes as the rays say") {
    const OneThread one_thread;
    std::uint64_t wrong = 0, visible = 0;
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        Random random(seed);
        ShadowScene scene;
        scene.viewport = {24, 24};
        scene.cull = raster::CullMode::none;
        scene.add(loose_triangles(seed));
        if (random.integer(0, 1)) scene.add("cube", 1, random.in_box(1.0f), glm::vec3(random.real(0.2f, 1.0f)));
        scene.camera.position = random.in_box(4.0f);
        scene.light = random.integer(0, 1) ? point_light(random.in_box(3.0f)) : directional_light(random.in_box(1.0f));
        scene.draw();
        const std::vector<float> exact = exact_factors(scene);
        const ShadowError error = compare_shadows(scene.frame.samples(), exact, irregular_factors(scene), 1);
        wrong += error.misclassified();
        visible += error.visible;
    }
    CHECK(visible > 100000);
    CHECK(wrong == 0);
}

TEST_CASE("irregular z-buffer: the grid holds every visible sample once in the cell where the light sees it") {
    for (const ShadowLight& light : {directional_light({-1, -2, 0.3f}), point_light({-0.9f, -0.4f, 0.9f})}) {
        ShadowScene scene;
        add_room(scene);
        scene.draw();
        std::vector<int> found(scene.sample_count(), 0);
        for (const LightGrid& grid : make_light_grids(light, scene.frame.samples())) {
            REQUIRE(grid.begin.size() == static_cast<std::size_t>(grid.columns) * grid.rows + 1);
            CHECK(grid.begin.back() == grid.points.size());
            for (int row = 0; row < grid.rows; ++row) {
                for (int column = 0; column < grid.columns; ++column) {
                    const std::size_t cell = static_cast<std::size_t>(row) * grid.columns + column;
                    for (std::uint32_t i = grid.begin[cell]; i < grid.begin[cell + 1]; ++i) {
                        const LightPoint& point = grid.points[i];
                        const glm::dvec2 place = grid.place(project(grid.view, scene.frame.position[point.sample]));
                        ++found[point.sample];
                        CHECK(int(place.x) == column);
                        CHECK(int(place.y) == row);
                    }
                }
            }
        }
        for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] == (scene.is_seen(i) ? 1 : 0));
    }
}

TEST_CASE("irregular z-buffer: the cells of a triangle are those it touches - by cutting it with every cell") {
    Random random(5);
    LightGrid grid;
    grid.view = grid_views(directional_light({0, 0, -1}))[0];
    grid.low = glm::dvec2(-1.0);
    grid.high = glm::dvec2(1.0);
    grid.columns = 13;
    grid.rows = 9;
    for (int round = 0; round < 500; ++round) {
        const float reach = random.integer(0, 1) ? 2.0f : 0.3f;
        const Triangle t{random.in_box(reach), random.in_box(reach), random.in_box(reach)};
        const LightTriangle triangle = set_up(grid, t);
        int listed = 0;
        std::vector<bool> is_listed(13 * 9, false);
        for (int row = triangle.first_row; row <= triangle.last_row; ++row) {
            const CellRange cells = cells_in_row(grid, triangle, row);
            for (int column = cells.first; column <= cells.last; ++column, ++listed)
                is_listed[row * 13 + column] = true;
        }
        int touched = 0;
        for (int row = 0; row < 9; ++row) {
            for (int column = 0; column < 13; ++column) {
                bool inside = false;  // some of 40 x 40 points of the cell lies in the triangle
                for (int k = 0; k < 1600 && !inside; ++k) {
                    const glm::dvec2 cells(column + (k % 40 + 0.5) / 40, row + (k / 40 + 0.5) / 40);
                    const glm::dvec2 seen = grid.low + cells / glm::dvec2(13, 9) * (grid.high - grid.low);
                    const glm::dvec3 q(seen, 1.0);
                    const double u = glm::dot(triangle.edge[0], q), v = glm::dot(triangle.edge[1], q),
                                 w = glm::dot(triangle.edge[2], q);
                    inside = (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
                }
                touched += inside;
                if (inside) CHECK(is_listed[row * 13 + column]);
            }
        }
        CHECK(listed <= touched + 40);  // conservative, but no box: 117 cells
    }
}
