// 50_environment: the two layouts against angles in double and OpenGL's table, no seam, and what one NaN does.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "course.hpp"
#include "lighting/environment/cube_map.hpp"
#include "lighting/environment/environment_image.hpp"
#include "tools/draw/draw.hpp"

using namespace kreda;
using namespace kreda::tests;
using glm::dvec3;
using glm::vec3;
using std::numbers::pi;

namespace {

/// 0.5 + 0.5 d in 8 bits of sRGB: half a code is up to 1.2 / 255 of linear light, twice that in d, and the mean of a
/// pixel is a little shorter than 1.
constexpr double kDirectionError = 0.013;

dvec3 direction_of_color(const vec3& color) {
    return 2.0 * dvec3(color) - 1.0;
}

/// OpenGL 4.6, table 8.19: s and t of a face, divided by its main axis.
struct FacePlace {
    double s, t, along;
};

FacePlace place_on_face(int face, const dvec3& r) {
    switch (face) {
        case 0: return {-r.z, -r.y, r.x};
        case 1: return {r.z, -r.y, -r.x};
        case 2: return {r.x, r.z, r.y};
        case 3: return {r.x, -r.z, -r.y};
        case 4: return {r.x, -r.y, r.z};
        default: return {-r.x, -r.y, -r.z};
    }
}

/// The largest step of green between pixels one above the other, above the captions.
float largest_step(const raster::Image& panel) {
    float largest = 0.0f;
    for (int y = 1; y < panel.height - 14; ++y) {
        for (int x = 0; x < panel.width; ++x) {
            largest = std::max(largest, std::abs(panel.at(1, x, y) - panel.at(1, x, y - 1)));
        }
    }
    return largest;
}

int count_color(const raster::Image& panel, const vec3& color) {
    int count = 0;
    for (int y = 0; y < panel.height; ++y) {
        for (int x = 0; x < panel.width; ++x) count += glm::distance(panel.rgb(x, y), color) < 0.02f ? 1 : 0;
    }
    return count;
}

}  // namespace

TEST_CASE("50_environment: every pixel of the image of directions shows the direction of its angles") {
    const raster::Image panel = linear_panel("50_environment/layouts", 3, 2, 3);
    const int width = 104, height = 52, top = (panel.height - height) / 2;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double azimuth = 2.0 * pi * ((x + 0.5) / width - 0.5), polar = pi * (y + 0.5) / height;
            const dvec3 d(std::sin(polar) * std::cos(azimuth), std::cos(polar), std::sin(polar) * std::sin(azimuth));
            CHECK(glm::distance(direction_of_color(panel.rgb(x, top + y)), d) < kDirectionError);
        }
    }
}

TEST_CASE("50_environment: every pixel of the cube of directions lies where OpenGL's table puts its direction") {
    const raster::Image panel = linear_panel("50_environment/layouts", 3, 2, 4);
    const int side = 26, top = (panel.height - 3 * side) / 2;
    const glm::ivec2 corners[] = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}};
    for (int face = 0; face < 6; ++face) {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const glm::ivec2 at = side * corners[face] + glm::ivec2(x, y + top);
                const FacePlace place = place_on_face(face, direction_of_color(panel.rgb(at.x, at.y)));
                CHECK(place.along > 0.0);
                // In a corner the axis is 1 / sqrt 3 of the direction: its error counts that much more.
                CHECK(std::abs(place.s / place.along - ((x + 0.5) / side * 2.0 - 1.0)) < 2.5 * kDirectionError);
                CHECK(std::abs(place.t / place.along - ((y + 0.5) / side * 2.0 - 1.0)) < 2.5 * kDirectionError);
            }
        }
    }
}

TEST_CASE("50_environment: the numbers of the page") {
    const auto number = [](const char* key) { return doctest::Approx(documented_number("50_environment", key)); };
    CHECK(0.5 + std::atan2(2.0, -3.0) / (2.0 * pi) == number("image_u").epsilon(1e-4));
    CHECK(0.5 - std::atan2(1.0, std::hypot(3.0, 2.0)) / pi == number("image_v").epsilon(1e-4));
    CHECK((2.0 / 3.0 + 1.0) / 2.0 == number("cube_u").epsilon(1e-4));
    CHECK((-1.0 / 3.0 + 1.0) / 2.0 == number("cube_v").epsilon(1e-4));
    const double middle = lighting::texel_solid_angle(1024, 512, 512), corner = lighting::texel_solid_angle(1024, 0, 0);
    CHECK(middle / corner == number("ratio").epsilon(5e-3));  // 3 sqrt 3 for texels that are points
}

TEST_CASE("50_environment: with the neighbours' texels there is no step and without them there is one") {
    const auto step = [](int panel) { return largest_step(linear_panel("50_environment/seams", 2, 2, panel)); };
    CHECK(step(0) > 3.0f * step(1));  // 0.104 against 0.019
    CHECK(step(2) > 3.0f * step(3));  // 0.229 against 0.018
}

TEST_CASE("50_environment: one texel that is no number takes the light from everywhere until it is repaired") {
    const auto panel = [](int i) { return linear_panel("50_environment/repairs", 2, 2, i); };
    CHECK(count_color(panel(0), tools::kRed) == 2 * 16);  // two texels of 4 x 4 pixels
    CHECK(count_color(panel(0), tools::kBlue) == 16);
    CHECK(count_color(panel(1), tools::kRed) == 0);
    CHECK(count_color(panel(1), tools::kBlue) == 0);
    CHECK(count_color(panel(2), tools::kRed) > 128 * 64 * 7 / 10);  // all but the caption
    CHECK(count_color(panel(3), tools::kRed) == 0);
}
