// Directions chosen by an environment's light: the density is one in all, and it is that of the directions chosen.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "lighting/environment/light_table.hpp"
#include "lighting/importance.hpp"

using namespace kreda::lighting;
using glm::vec3;

namespace {

/// A dim sky with one texel of sun and its border.
CubeMap sun_and_sky(int size, float sun) {
    CubeMap map = make_cube_map({size});
    for (int face = 0; face < kCubeFaces; ++face) {
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) map.set_texel(0, face, x, y, vec3(0.5f));
        }
    }
    map.set_texel(0, 2, size / 3, size / 4, vec3(sun));
    fill_border(map, 0);
    return map;
}

/// The sum over directions in the middle of 4 x 4 parts of every texel, times the solid angle of a part.
template <class Value>
double over_all_directions(int size, Value value) {
    double sum = 0.0;
    const int parts = 4 * size;
    for (int face = 0; face < kCubeFaces; ++face) {
        for (int y = 0; y < parts; ++y) {
            for (int x = 0; x < parts; ++x)
                sum += value(glm::normalize(texel_direction(parts, face, x, y))) * texel_solid_angle(parts, x, y);
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("Light table: the density is one over all directions together and nowhere zero where light is") {
    for (const float sun : {0.5f, 1e4f, 1e6f}) {
        const CubeMap map = sun_and_sky(16, sun);
        const LightTable table = make_light_table(map);
        const double all = over_all_directions(16, [&](const vec3& d) { return light_density(table, d); });
        CHECK(all == doctest::Approx(1.0).epsilon(2e-3));  // the solid angle of a part stands for one point's |d|^3
        CHECK(*std::min_element(table.density.begin(), table.density.end()) > 0.0f);
    }
}

TEST_CASE("Light table: directions chosen by it and divided by its density sum to the sphere and to the light") {
    const CubeMap map = sun_and_sky(16, 1e4f);
    const LightTable table = make_light_table(map);
    constexpr int kSamples = 16384;
    double light = 0.0;
    for (int k = 0; k < kSamples; ++k) {
        const vec3 d = choose_light(table, hammersley(k, kSamples));
        CHECK(std::abs(glm::length(d) - 1.0f) < 1e-6f);
        light += sample_level(map, 0, d).x / light_density(table, d) / kSamples;
    }
    const double exact = over_all_directions(16, [&](const vec3& d) { return double(sample_level(map, 0, d).x); });
    CHECK(light == doctest::Approx(exact).epsilon(5e-3));  // 4 x 4 points a texel, and the samples' own error
}

TEST_CASE("Light table: without light every direction is as likely as any other") {
    const LightTable table = make_light_table(make_cube_map({8}));
    for (int k = 0; k < 64; ++k) {
        const vec3 d = choose_light(table, hammersley(k, 64));
        // The density is even within a texel of the cube, not on the sphere: within 15 % on texels this large.
        CHECK(light_density(table, d) == doctest::Approx(0.25 / std::numbers::pi).epsilon(0.15));
    }
}

TEST_CASE("Light table: edges and corners of the cube lie in a texel of their face") {
    for (const int size : {1, 7, 16}) {
        for (const float x : {-1.0f, 0.0f, 1.0f}) {
            for (const float y : {-1.0f, 0.0f, 1.0f}) {
                for (const float z : {-1.0f, 0.0f, 1.0f}) {
                    if (x == 0.0f && y == 0.0f && z == 0.0f) continue;
                    const DensityTap tap = density_tap(size, {x, y, z});
                    CHECK(tap.texel / (size * size) == cube_point({x, y, z}).face);
                }
            }
        }
    }
}
