// Light sources against numbers worked by hand.
#include <cmath>
#include <initializer_list>

#include <doctest/doctest.h>

#include "lighting/light.hpp"
#include "lighting/light_sample.hpp"

using namespace kreda::lighting;

namespace {

Light spot_light(float inner_deg, float outer_deg) {
    Light light;
    light.type = LightType::spot;
    light.position = {0, 2, 0};
    light.direction = {0, -3, 0};
    light.inner_cone_deg = inner_deg;
    light.outer_cone_deg = outer_deg;
    return light;
}

/// Light of the spot on the ground at this angle from its axis, without attenuation.
float at_angle(const Light& spot, double angle_deg) {
    const float x = static_cast<float>(2.0 * std::tan(angle_deg * 3.14159265358979 / 180.0));
    return sample(spot, {x, 0, 0}).irradiance.x;
}

}  // namespace

TEST_CASE("A directional light comes from the same side with the same strength everywhere") {
    Light sun;
    sun.direction = {0, -5, 0};
    sun.color = {1, 0.5f, 0.25f};
    sun.intensity = 2.0f;
    for (const glm::vec3 p : {glm::vec3(0, 0, 0), glm::vec3(100, -3, 7)}) {
        const LightSample s = sample(sun, p);
        CHECK(s.l == glm::vec3(0, 1, 0));
        CHECK(s.irradiance == glm::vec3(2, 1, 0.5f));
    }
}

TEST_CASE("A point light at (3 4 0) is five away from the origin and shines along (0.6 0.8 0)") {
    Light lamp;
    lamp.type = LightType::point;
    lamp.position = {3, 4, 0};
    lamp.attenuation = {1, 0.2f, 0.04f};  // 1 / (1 + 1 + 1) at distance 5
    const LightSample s = sample(lamp, {0, 0, 0});
    CHECK(s.l.x == doctest::Approx(0.6));
    CHECK(s.l.y == doctest::Approx(0.8));
    CHECK(s.irradiance.x == doctest::Approx(1.0 / 3.0));
}

TEST_CASE("At the lamp itself there is no direction and nothing is not a number") {
    Light lamp;
    lamp.type = LightType::point;
    lamp.position = {1, 2, 3};
    const LightSample s = sample(lamp, {1, 2, 3});
    CHECK(s.l == glm::vec3(0.0f));
    CHECK(std::isfinite(s.irradiance.x));
}

TEST_CASE("A spot is full inside its inner cone and dark outside its outer one and never rises between") {
    const Light spot = spot_light(20, 30);
    CHECK(at_angle(spot, 0) == 1.0f);
    CHECK(at_angle(spot, 19.9) == doctest::Approx(1.0));
    CHECK(at_angle(spot, 30.1) == 0.0f);
    float before = 1.0f;
    for (double angle = 15; angle < 35; angle += 0.25) {
        const float now = at_angle(spot, angle);
        CHECK(now <= before + 1e-6f);  // rounding of the cosine
        before = now;
    }
}

TEST_CASE("Equal cones make a hard edge") {
    const Light spot = spot_light(25, 25);
    CHECK(at_angle(spot, 24.9) == 1.0f);
    CHECK(at_angle(spot, 25.1) == 0.0f);
}

TEST_CASE("Half way between the cosines of the cones a spot gives one half") {
    CHECK(spot_cone(0.75f, 1.0f, 0.5f) == doctest::Approx(0.5));  // 3 t^2 - 2 t^3 at t = 1/2
}
