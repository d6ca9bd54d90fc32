// Equirectangular images: directions, solid angles, repair, and no seam at the meridian or the poles.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "lighting/environment/environment_image.hpp"

using namespace kreda::lighting;
namespace raster = kreda::raster;
using glm::vec2;
using glm::vec3;
using std::numbers::pi;

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

raster::Image random_image(int width, int height) {
    raster::Image image = raster::make_image(width, height, 3);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> value(0.0f, 1.0f);
    for (float& v : image.values) v = value(random);
    return image;
}

double largest_difference(const vec3& a, const vec3& b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

}  // namespace

TEST_CASE("equirect: the axes lie where the header says") {
    CHECK(equirect_point({2.0f, 0.0f, 0.0f}) == vec2(0.5f, 0.5f));
    CHECK(equirect_point({0.0f, 0.0f, -2.0f}) == vec2(0.25f, 0.5f));
    CHECK(equirect_point({0.0f, 0.0f, 2.0f}) == vec2(0.75f, 0.5f));
    CHECK(equirect_point({0.0f, 2.0f, 0.0f}).y == 0.0f);
    CHECK(equirect_point({0.0f, -2.0f, 0.0f}).y == 1.0f);
}

TEST_CASE("equirect: a direction's point leads back to the direction and is the angles of double") {
    std::mt19937 random(3);
    std::normal_distribution<float> component;
    double worst = 0.0, worst_angle = 0.0;
    for (int i = 0; i < 100000; ++i) {
        const vec3 d = glm::normalize(vec3(component(random), component(random), component(random)));
        const vec2 point = equirect_point(d);
        worst = std::max(worst, largest_difference(equirect_direction(point), d));
        const double u = 0.5 + std::atan2(double(d.z), double(d.x)) / (2.0 * pi);
        const double v = 0.5 - std::atan2(double(d.y), std::hypot(double(d.x), double(d.z))) / pi;
        worst_angle = std::max({worst_angle, std::abs(point.x - u), std::abs(point.y - v)});
    }
    CHECK(worst_angle < 2.5e-7);       // 6e-8 turns, doubled for v, and the rounding of the sums
    CHECK(worst < 2.0 * pi * 2.5e-7);  // a turn is 2 pi long
}

TEST_CASE("equirect: every texel's direction leads back to the texel") {
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 128; ++x) {
            const vec2 point =
                equirect_point(equirect_direction({(float(x) + 0.5f) / 128.0f, (float(y) + 0.5f) / 64.0f}));
            CHECK(static_cast<int>(point.x * 128.0f) == x);
            CHECK(static_cast<int>(point.y * 64.0f) == y);
        }
    }
}

TEST_CASE("equirect: the solid angles of all texels sum to 4 pi and their mirror images are equal") {
    for (const int height : {1, 2, 7, 512}) {
        CAPTURE(height);
        double sum = 0.0;
        for (int y = 0; y < height; ++y) {
            sum += 2 * height * equirect_solid_angle(2 * height, height, y);
            const double other = equirect_solid_angle(2 * height, height, height - 1 - y);
            CHECK(equirect_solid_angle(2 * height, height, y) == doctest::Approx(other).epsilon(1e-9));
        }
        CHECK(std::abs(sum - 4.0 * pi) < 1e-12);
    }
    // The rule of the middle is too large by the factor x / sin x, x = pi / 2H, everywhere.
    const double x = pi / 1024.0;
    const double middle = 2.0 * pi / 1024.0 * pi / 512.0 * std::sin(pi * 100.5 / 512.0);
    CHECK(middle / equirect_solid_angle(1024, 512, 100) == doctest::Approx(x / std::sin(x)).epsilon(1e-10));
}

TEST_CASE("repair: each bad texel is counted once by its worst channel and becomes a radiance") {
    raster::Image image = raster::make_image(8, 4, 3);
    for (float& v : image.values) v = 2.0f;
    image.set_rgb(0, 0, {kNaN, -1.0f, kInf});
    image.set_rgb(3, 1, {1.0f, kInf, -1.0f});
    image.set_rgb(5, 2, {-1.0f, 0.0f, 7.0f});
    image.set_rgb(6, 3, {-kInf, 1.0f, 1.0f});
    const EnvironmentRepairs repairs = repair_environment(image);
    CHECK(repairs.nan == 1);
    CHECK(repairs.infinite == 1);
    CHECK(repairs.negative == 2);
    CHECK(repairs.total() == 4);
    CHECK(image.rgb(0, 0) == vec3(2.0f, 0.0f, 7.0f));  // the mean of its neighbours, black, the largest finite value
    CHECK(image.rgb(3, 1) == vec3(1.0f, 7.0f, 0.0f));
    CHECK(image.rgb(5, 2) == vec3(0.0f, 0.0f, 7.0f));
    CHECK(image.rgb(6, 3) == vec3(0.0f, 1.0f, 1.0f));
    CHECK(repair_environment(image).total() == 0);
}

TEST_CASE("repair: an image of nothing but NaN is black and no value stays above the largest radiance") {
    raster::Image image = raster::make_image(4, 2, 3);
    for (float& v : image.values) v = kNaN;
    CHECK(repair_environment(image).nan == 8);
    for (const float v : image.values) CHECK(v == 0.0f);
    image.set_rgb(1, 1, {1e30f, 1.0f, kInf});
    image.set_rgb(2, 1, {0.0f, 2e9f, 1.0f});
    const EnvironmentRepairs repairs = repair_environment(image);
    CHECK(repairs.infinite == 1);
    CHECK(repairs.too_bright == 1);
    CHECK(repairs.total() == 2);
    CHECK(image.rgb(2, 1) == vec3(0.0f, kMaxRadiance, 1.0f));
    CHECK(image.rgb(1, 1) == vec3(kMaxRadiance, 1.0f, kMaxRadiance));
}

TEST_CASE("equirect: the middle of a texel shows the texel") {
    const raster::Image image = random_image(16, 8);
    const EquirectMap map = make_equirect_map(image);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 16; ++x) {
            const vec3 seen =
                sample_equirect(map, equirect_direction({(float(x) + 0.5f) / 16.0f, (float(y) + 0.5f) / 8.0f}));
            CHECK(largest_difference(seen, image.rgb(x, y)) < 1e-5);  // 16 texels a turn, angles right to 2.5e-7 turns
        }
    }
}

TEST_CASE("equirect: filtering has no seam at the meridian nor across the poles") {
    const EquirectMap map = make_equirect_map(random_image(16, 8));
    for (int i = 0; i <= 100; ++i) {
        CAPTURE(i);
        const float height = -3.0f + 0.06f * static_cast<float>(i);
        const vec3 before = sample_equirect(map, {-1.0f, height, 1e-6f});
        const vec3 behind = sample_equirect(map, {-1.0f, height, -1e-6f});
        CHECK(largest_difference(before, behind) < 2e-5);  // neighbours differ by at most 1, 16 texels a turn
        const raster::SinCos azimuth = raster::sin_cos_of_turns(0.01f * static_cast<float>(i));
        for (const float pole : {1.0f, -1.0f}) {
            const vec3 near = sample_equirect(map, {1e-6f * azimuth.cos, pole, 1e-6f * azimuth.sin});
            const vec3 far = sample_equirect(map, {-1e-6f * azimuth.cos, pole, -1e-6f * azimuth.sin});
            CHECK(largest_difference(near, far) < 2e-5);
        }
    }
}

TEST_CASE("cube from equirect: a linear radiance keeps its values and its total 8 pi") {
    raster::Image image = raster::make_image(512, 256, 3);
    const auto L = [](const vec3& d) { return vec3(2.0f + d.x, 2.0f + d.y, 2.0f - 0.5f * d.z); };
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 512; ++x) {
            image.set_rgb(x, y, L(equirect_direction({(float(x) + 0.5f) / 512.0f, (float(y) + 0.5f) / 256.0f})));
        }
    }
    const CubeMap map = cube_from_equirect(image, 64);
    REQUIRE(map.last_level() == 6);
    glm::dvec3 sum(0.0);
    double worst = 0.0;
    for (int i = 0; i < kCubeFaces * 64 * 64; ++i) {
        const int face = i / 4096, x = i % 64, y = i / 64 % 64;
        sum += glm::dvec3(map.texel(0, face, x, y)) * texel_solid_angle(64, x, y);
        worst = std::max(
            worst, largest_difference(map.texel(0, face, x, y), L(glm::normalize(texel_direction(64, face, x, y)))));
    }
    for (int c = 0; c < 3; ++c) CHECK(sum[c] == doctest::Approx(8.0 * pi).epsilon(1e-5));
    // The mean over a texel (half width h = 1/64) falls short by about h^2 / 3, the image's interpolation by less.
    CHECK(worst < 2e-4);
}

TEST_CASE("cube_size_for: a quarter of the width as a power of two within the limits") {
    CHECK(cube_size_for(1024, 1024) == 256);
    CHECK(cube_size_for(1025, 1024) == 512);
    CHECK(cube_size_for(16, 1024) == 128);
    CHECK(cube_size_for(16384, 1024) == 1024);
}
