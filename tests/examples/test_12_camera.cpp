// The table of 12_camera, computed again in double without a matrix.
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "course.hpp"

using namespace kreda::tests;

TEST_CASE("12 camera: the corner's window position follows from dot products and similar triangles") {
    const double cos30 = std::sqrt(0.75), sin30 = 0.5;
    const glm::dvec3 scaled(0.6);
    const glm::dvec3 world(cos30 * scaled.x + sin30 * scaled.z - 0.3, scaled.y + 0.2,
                           -sin30 * scaled.x + cos30 * scaled.z);
    const glm::dvec3 eye(1.2, 1.6, 4.4), target(0.2, 0.0, 0.0);
    const glm::dvec3 forward = glm::normalize(target - eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
    const glm::dvec3 up = glm::cross(right, forward);
    const glm::dvec3 to_corner = world - eye;

    const double distance = glm::dot(to_corner, forward);
    const double half_height = distance * std::tan(20.0 / 180.0 * 3.14159265358979);
    const double x = 320 + 180 * glm::dot(to_corner, right) / half_height;
    const double y = 180 - 180 * glm::dot(to_corner, up) / half_height;
    CHECK(std::abs(distance - documented_number("12_camera", "clip_w")) < 0.0006);         // three decimals
    CHECK(std::abs(x - documented_number("12_camera", "window_x")) < 0.5 / 256 + 0.0006);  // and the snap to 1/256
    CHECK(std::abs(y - documented_number("12_camera", "window_y")) < 0.5 / 256 + 0.0006);
}
