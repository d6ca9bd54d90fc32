// The polygons of 14_clipping, by hand.
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "course.hpp"
#include "raster/camera.hpp"
#include "raster/clip.hpp"
#include "raster/screen.hpp"

using namespace kreda;
using namespace kreda::tests;

TEST_CASE("14 clipping: the new corners of the road lie one unit before the eye and on the road's sides") {
    const raster::Camera camera{.position = {0.0f, 0.6f, 2.0f},
                                .target = {0.0f, 0.35f, 0.0f},
                                .vertical_fov_deg = 75.0f,
                                .near = 1.0f,
                                .far = 6.0f};
    const glm::dvec3 road[3] = {{0.2, 0.0, -3.5}, {-1.6, 0.0, 2.9}, {1.3, 0.0, 2.4}};
    const glm::mat4 clip = clip_from_world(camera, 16.0f / 9.0f);
    const auto clipped = [&](int i) { return clip * glm::vec4(glm::vec3(road[i]), 1.0f); };
    const raster::ClipPolygon polygon = raster::clip_triangle(clipped(0), clipped(1), clipped(2), 1000.0f, 1000.0f);
    REQUIRE(polygon.count == documented_number("14_clipping", "road_corners"));

    const glm::dvec3 eye(0.0, 0.6, 2.0);
    const glm::dvec3 forward = glm::normalize(glm::dvec3(0.0, -0.25, -2.0));
    const double tip_distance = glm::dot(road[0] - eye, forward);
    CHECK(std::abs(tip_distance - documented_number("14_clipping", "tip_w")) < 0.005);  // two decimals
    for (int i = 1; i < 3; ++i) {
        const double distance = glm::dot(road[i] - eye, forward);
        const double t = (tip_distance - 1.0) / (tip_distance - distance);  // along the side from the tip to corner i
        bool found = false;
        for (int k = 0; k < polygon.count; ++k) {
            const glm::vec3 w = polygon.vertex[k].weights;
            // Single precision of the clip coordinates.
            found = found || (std::abs(w[i] - t) < 1e-5 && std::abs(w[0] - (1 - t)) < 1e-5);
        }
        CHECK(found);
    }
}

TEST_CASE("14 clipping: a guard band of 2 cuts two corners off and adds four") {
    const raster::ClipPolygon polygon =
        raster::clip_triangle({0.5f, 0.1f, 0, 1}, {1.5f, 2.5f, 0, 1}, {2.6f, -0.7f, 0, 1}, 2.0f, 2.0f);
    CHECK(polygon.count == documented_number("14_clipping", "guard_corners"));
}

TEST_CASE("14 clipping: the guard band of a picture 640 wide is the page's") {
    // Half of 640 is 320; 16383 / 320 = 51.2, and 32 is the power of two below.
    CHECK(raster::guard_band_ndc(640) == documented_number("14_clipping", "guard_640"));
}
