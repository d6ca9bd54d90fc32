// Fog against numbers worked by hand, and at the extremes.
#include <cmath>
#include <initializer_list>
#include <limits>

#include <doctest/doctest.h>

#include "lighting/batch/fog_passes.hpp"
#include "lighting/fog.hpp"

using namespace kreda::lighting;

TEST_CASE("Linear fog from 2 to 10 leaves 0.75 at 4 and is cut to 0..1") {
    CHECK(fog_linear(4, 2, 10) == 0.75f);
    CHECK(fog_linear(1, 2, 10) == 1.0f);
    CHECK(fog_linear(11, 2, 10) == 0.0f);
}

TEST_CASE("Exponential fog of density 0.5 leaves 1/e at 2 and squared fog e^-1 and e^-4 at 2 and 4") {
    CHECK(fog_exp(2, 0.5f) == doctest::Approx(std::exp(-1.0)).epsilon(2e-7));  // 2 ulp
    CHECK(fog_exp2(2, 0.5f) == doctest::Approx(std::exp(-1.0)).epsilon(2e-7));
    CHECK(fog_exp2(4, 0.5f) == doctest::Approx(std::exp(-4.0)).epsilon(2e-7));
}

TEST_CASE("Only exponential fog is the same for one long way and two short ones") {
    CHECK(fog_exp(5, 0.3f) == doctest::Approx(double{fog_exp(2, 0.3f)} * fog_exp(3, 0.3f)).epsilon(1e-6));
    CHECK(fog_exp2(5, 0.3f) < 0.5 * double{fog_exp2(2, 0.3f)} * fog_exp2(3, 0.3f));
}

TEST_CASE("Fog that starts where it ends is a wall") {
    CHECK(fog_linear(2.9f, 3, 3) == 1.0f);
    CHECK(fog_linear(3.0f, 3, 3) == 0.0f);
    CHECK(fog_linear(3.1f, 3, 3) == 0.0f);
}

TEST_CASE("Clear air stays clear at any distance and nothing is ever not a number") {
    const float infinity = std::numeric_limits<float>::infinity();
    CHECK(fog_exp(infinity, 0.0f) == 1.0f);
    CHECK(fog_exp2(infinity, 0.0f) == 1.0f);
    CHECK(fog_exp(infinity, 1.0f) == 0.0f);
    CHECK(fog_exp2(1e30f, 1e30f) == 0.0f);
    CHECK(fog_linear(infinity, 2, 10) == 0.0f);
}

TEST_CASE("The mix is exact at both ends and lies between the colours") {
    const glm::vec3 surface(0.1f, 0.7f, 1.3f), fog(0.33f, 0.2f, 0.9f);
    CHECK(mix_fog(1.0f, surface, fog) == surface);
    CHECK(mix_fog(0.0f, surface, fog) == fog);
    for (float f = 0.0f; f <= 1.0f; f += 0.0625f) {
        const glm::vec3 mixed = mix_fog(f, surface, fog);
        for (int c = 0; c < 3; ++c) {
            CHECK(mixed[c] >= std::fmin(surface[c], fog[c]) * (1.0f - 2e-7f));
            CHECK(mixed[c] <= std::fmax(surface[c], fog[c]) * (1.0f + 2e-7f));
        }
    }
}

TEST_CASE("A factor from the vertices that rounding put beyond 1 takes no light away") {
    static kreda::raster::Fragments fragments;
    static LightingChannels channels;
    fragments.count = 3;
    const float factors[] = {1.0f + 0x1p-23f, -0x1p-30f, 0.25f};
    for (int i = 0; i < 3; ++i) {
        fragments.fog.set(i, factors[i]);
        channels.radiance.set(i, glm::vec3(0.0f));
    }
    copy_fog(fragments, channels);
    apply_fog(3, glm::vec3(1e9f), channels);
    CHECK(channels.radiance.at(0) == glm::vec3(0.0f));
    CHECK(channels.radiance.at(1) == glm::vec3(1e9f));
    CHECK(channels.radiance.at(2) == glm::vec3(0.75e9f));
}

TEST_CASE("Turning the camera changes the planar distance and not the radial one") {
    const glm::vec3 eye(1, 2, 3), p(4, 6, 3);  // 5 away, along (0.6 0.8 0)
    CHECK(radial_distance(p, eye) == doctest::Approx(5.0));
    CHECK(planar_distance(p, eye, {1, 0, 0}) == doctest::Approx(3.0));
    CHECK(planar_distance(p, eye, {0, 1, 0}) == doctest::Approx(4.0));
    CHECK(planar_distance(p, eye, {-1, 0, 0}) == 0.0f);  // behind the eye's plane
}

TEST_CASE("The largest difference of planar and radial fog is the closed form's") {
    // At a picture's corner radial = k planar. exp: k^(-1/(k-1)) (1 - 1/k) is the largest gap; k = 1.54494 (60 degrees,
    // 16:9) gives 0.15877.
    const double k = 1.54494;
    double largest = 0.0;
    for (int i = 1; i < 4000; ++i) {
        const double z = i * 0.002;
        largest =
            std::fmax(largest, double{fog_exp(static_cast<float>(z), 1.0f)} - fog_exp(static_cast<float>(k * z), 1.0f));
    }
    CHECK(largest == doctest::Approx(0.15877).epsilon(1e-4));
}
