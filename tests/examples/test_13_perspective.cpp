// The perspective-correct floor of 13_perspective against rays that hit the plane y = 0, in double.
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "course.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

struct Counts {
    int compared = 0, wrong = 0;
};

/// Compare one panel of compare.png with rays, away from the squares' borders.
Counts compare_with_rays(int left, int width) {
    const raster::Image picture = golden_montage("13_perspective/compare", 2);
    const glm::dvec3 eye(0.3, 0.6, 1.45), target(0.0, 0.08, 0.0);
    const glm::dvec3 forward = glm::normalize(target - eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
    const glm::dvec3 up = glm::cross(right, forward);
    const double half_height = std::tan(27.5 / 180.0 * 3.14159265358979);
    Counts counts;
    for (int y = 0; y < picture.height - 16; ++y) {  // the caption is below
        for (int x = 0; x < width; ++x) {
            const double sx = ((x + 0.5) - 0.5 * width) / (0.5 * picture.height) * half_height;
            const double sy = (0.5 * picture.height - (y + 0.5)) / (0.5 * picture.height) * half_height;
            const glm::dvec3 ray = forward + sx * right + sy * up;
            if (ray.y > -1e-3) continue;
            const glm::dvec3 p = eye - (eye.y / ray.y) * ray;
            if (std::abs(p.x) > 0.99 || std::abs(p.z) > 0.99) continue;
            const double u = 4 * (p.x + 1), v = 4 * (p.z + 1);  // in squares; the parity does not care where v starts
            if (std::abs(u - std::round(u)) < 0.03 || std::abs(v - std::round(v)) < 0.03) continue;
            const bool dark = (int(u) + int(v)) % 2 == 0;
            ++counts.compared;
            counts.wrong += (picture.rgb(left + x, y).x < 0.6f) != dark ? 1 : 0;
        }
    }
    return counts;
}

}  // namespace

TEST_CASE("13 perspective: every square lies where a ray through the pixel meets the floor") {
    const Counts counts = compare_with_rays(162, 158);
    CHECK(counts.compared > 8000);
    CHECK(counts.wrong == 0);
}

TEST_CASE("13 perspective: affine interpolation puts a good part of the squares elsewhere") {
    const Counts counts = compare_with_rays(0, 158);
    CHECK(counts.wrong > counts.compared / 4);
}

TEST_CASE("13 perspective: the page's middle of the screen is a quarter of the way") {
    const double a = (0.5 * 0.0 / 1 + 0.5 * 1.0 / 3) / (0.5 / 1 + 0.5 / 3);
    CHECK(a == doctest::Approx(documented_number("13_perspective", "middle")).epsilon(1e-12));
}
