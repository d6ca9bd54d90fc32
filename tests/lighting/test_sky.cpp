// Built-in skies: radiance worked by hand in the directions that matter, and no direction without light of a sort.
#include <cmath>
#include <initializer_list>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "lighting/environment/sky.hpp"
#include "lighting/importance.hpp"

using namespace kreda::lighting;
using glm::vec3;

namespace {

const vec3 kUp{0, 1, 0}, kDown{0, -1, 0};

void check_near(const vec3& got, const vec3& expected, double epsilon = 1e-5) {
    for (int c = 0; c < 3; ++c) CHECK(got[c] == doctest::Approx(expected[c]).epsilon(epsilon));
}

}  // namespace

TEST_CASE("sky: a smooth step is 0 and 1 at its ends and a half in the middle in either direction") {
    CHECK(smooth_step(1.0f, 3.0f, 0.5f) == 0.0f);
    CHECK(smooth_step(1.0f, 3.0f, 1.0f) == 0.0f);
    CHECK(smooth_step(1.0f, 3.0f, 1.5f) == 0.15625f);  // 3/16 - 2/64
    CHECK(smooth_step(1.0f, 3.0f, 2.0f) == 0.5f);
    CHECK(smooth_step(1.0f, 3.0f, 9.0f) == 1.0f);
    CHECK(smooth_step(0.1f, -0.6f, -0.25f) == doctest::Approx(0.5));
}

TEST_CASE("sky: the gradient is earth below and sky above and 20 more in its sun") {
    check_near(gradient_sky(kUp), {0.4f, 0.6f, 1.0f});
    check_near(gradient_sky(kDown), {0.3f, 0.25f, 0.2f});
    check_near(gradient_sky({-1, 0, 0}), {0.35f, 0.425f, 0.6f});
    const vec3 sun = glm::normalize(vec3(0.4f, 0.8f, 0.3f));
    check_near(gradient_sky(sun), {20.3924f, 20.5734f, 20.9392f}, 3e-5);  // (d.sun)^256: 256 roundings of 6e-8
    // Half of 20 where (d.sun)^256 = 1/2: 4.2146 degrees from the sun.
    const kreda::raster::OrthonormalFrame around = frame_around(sun);
    const double angle = std::acos(std::pow(0.5, 1.0 / 256.0));
    const vec3 beside = to_world(around, {float(std::sin(angle)), 0.0f, float(std::cos(angle))});
    const float t = 0.5f * beside.y + 0.5f;
    CHECK(gradient_sky(beside).x == doctest::Approx(10.0 + 0.3 * (1.0 - t) + 0.4 * t).epsilon(1e-3));
}

TEST_CASE("sky: a soft box is 1 inside and a half at its edge and 0 beside and behind it") {
    const vec3 center{0, 0, 1}, right{1, 0, 0}, up{0, 1, 0};
    const auto box = [&](const vec3& d) { return soft_box(glm::normalize(d), center, right, up, 0.5f, 0.3f); };
    CHECK(box({0, 0, 1}) == 1.0f);
    CHECK(box({0.4f, 0.2f, 1}) == 1.0f);
    CHECK(box({0.5f, 0, 1}) == doctest::Approx(0.5));
    CHECK(box({-0.5f, 0.3f, 1}) == doctest::Approx(0.25));
    CHECK(box({0.55f, 0, 1}) == 0.0f);
    CHECK(box({0, -0.35f, 1}) == 0.0f);
    CHECK(box({0, 0, -1}) == 0.0f);
}

TEST_CASE("sky: the studio is dark above and lighter below and its lamps are where its words say") {
    check_near(studio_sky(kUp), {0.06f, 0.065f, 0.075f});
    check_near(studio_sky(kDown), {0.22f, 0.215f, 0.215f});
    check_near(studio_sky(glm::normalize(vec3(-0.57207754f, 0.57207754f, 0.58777855f))),
               {9.06f, 8.665f, 8.075f});  // key
    check_near(studio_sky(glm::normalize(vec3(0.93632918f, 0.28089875f, 0.21067407f))),
               {1.66f, 1.965f, 2.475f});                                                                  // fill
    check_near(studio_sky(glm::normalize(vec3(0, 0.31622777f, -0.94868330f))), {5.06f, 5.065f, 5.275f});  // strip
}

TEST_CASE("sky: the sunset is blue above and dark below and its sun stands low at -z") {
    // e^-5 of the horizon's colour is left at the zenith.
    check_near(sunset_sky(kUp),
               {0.1f + 0.65f * 0.006737947f, 0.16f + 0.20f * 0.006737947f, 0.36f - 0.16f * 0.006737947f}, 1e-4);
    check_near(sunset_sky(kDown), {0.055f, 0.045f, 0.04f});
    const vec3 sun = glm::normalize(vec3(0.2f, 0.09950372f, -0.97472f));
    const double h = std::exp(-5.0 * sun.y);
    const vec3 expected{float(0.10 * (1 - h) + 0.75 * h + 1.6 * h + 260.0),
                        float(0.16 * (1 - h) + 0.36 * h + 0.62 * h + 110.0),
                        float(0.36 * (1 - h) + 0.20 * h + 0.16 * h + 32.0)};
    check_near(sunset_sky(sun), expected, 1e-4);
}

TEST_CASE("sky: every direction has light that is finite and not negative and the name finds its formula") {
    for (const Sky sky : {Sky::studio, Sky::sunset, Sky::gradient}) {
        for (int i = 0; i < 2000; ++i) {
            const glm::vec2 u = hammersley(i, 2000);
            const vec3 d = around_normal(2.0f * u.y - 1.0f, u.x);
            const vec3 L = sky_radiance(sky, d);
            for (int c = 0; c < 3; ++c) {
                CHECK(std::isfinite(L[c]));
                CHECK(L[c] > 0.0f);
            }
            const vec3 by_name = sky == Sky::studio   ? studio_sky(d)
                                 : sky == Sky::sunset ? sunset_sky(d)
                                                      : gradient_sky(d);
            CHECK(L == by_name);
        }
    }
}
