// Irradiance: closed forms for constant light, one texel's cosine lobe, and the polynomial of one light.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "lighting/environment/irradiance.hpp"
#include "tests/lighting/even_light.hpp"

using namespace kreda::lighting;
using glm::vec3;
using kreda::tests::even_light;
using std::numbers::pi;

namespace {

const vec3 kNormals[] = {{0, 1, 0}, {0, -1, 0}, {0, 0, -1}, {0.6f, 0.0f, 0.8f}, {-0.3f, 0.5f, -0.7f}, {1, 1, 1}};

CubeMap one_texel(int size, int face, int x, int y, const vec3& L) {
    CubeMap map = make_cube_map(mip_sizes(size));
    map.set_texel(0, face, x, y, L);
    fill_border(map, 0);
    fill_mip_levels(map);
    return map;
}

}  // namespace

TEST_CASE("irradiance: the double sum of constant light is off by its closed form") {
    const CubeMap map = even_light(4, vec3(1.0f, 2.0f, 0.5f));
    for (const int N2 : {8, 16, 32, 64}) {
        const double x = pi / (2.0 * N2);
        for (const vec3& n : kNormals) {
            const vec3 middle = irradiance_of_hemisphere(map, n, 32, N2);
            const vec3 left = irradiance_of_hemisphere(map, n, 32, N2, 0.0f);
            for (int c = 0; c < 3; ++c) {  // some hundred sums in float
                const double L = map.texel(0, 0, 0, 0)[c];
                CHECK(middle[c] / (pi * L) == doctest::Approx(x / std::sin(x)).epsilon(3e-6));
                CHECK(left[c] / (pi * L) == doctest::Approx(x / std::tan(x)).epsilon(3e-6));
            }
        }
    }
}

TEST_CASE("irradiance: the cosine-weighted sum of constant light is pi L with any number of samples") {
    const CubeMap map = even_light(4, vec3(1.0f, 2.0f, 0.5f));
    for (const int N : {1, 7, 64, 1000}) {
        CHECK(irradiance_of_cosine(map, kNormals[4], N).y == doctest::Approx(2.0 * pi).epsilon(3e-6));
    }
}

TEST_CASE("irradiance: the sum over texels of constant light is pi L") {
    // max(n.l, 0) has a kink on the horizon that texels straddle: O(1 / N^2) of 64 x 64 texels a face.
    for (const vec3& n : kNormals) {
        CHECK(irradiance_of_texels(even_light(64, vec3(1.0f)), n).x == doctest::Approx(pi).epsilon(5e-4));
    }
}

TEST_CASE("irradiance: one bright texel gives its cosine lobe") {
    const CubeMap map = one_texel(64, 2, 20, 41, vec3(1000.0f, 10.0f, 0.0f));
    const vec3 l = glm::normalize(texel_direction(64, 2, 20, 41));
    const double w = texel_solid_angle(64, 20, 41);
    for (const vec3& n : kNormals) {
        const double cosine = std::max(0.0f, glm::dot(glm::normalize(n), l));
        const vec3 E = irradiance_of_texels(map, n);
        CHECK(E.x == doctest::Approx(1000.0 * w * cosine).epsilon(1e-5));
        CHECK(E.y == doctest::Approx(10.0 * w * cosine).epsilon(1e-5));
        CHECK(E.z == 0.0f);
    }
}

TEST_CASE("irradiance map: every way of summing writes pi L of constant light") {
    const CubeMap map = even_light(64, vec3(2.0f));
    for (const IrradianceSum sum : {IrradianceSum::texels, IrradianceSum::cosine, IrradianceSum::hemisphere}) {
        IrradianceSettings settings;
        settings.sum = sum;
        settings.size = 4;
        const CubeMap E = irradiance_map(map, settings);
        for (const vec3& n : kNormals) CHECK(sample_level(E, 0, n).x == doctest::Approx(2.0 * pi).epsilon(6e-4));
    }
}

TEST_CASE("SH9: one light gives the published polynomial and 0 where that is negative") {
    const auto E = [](double cosine) {
        const vec3 l = glm::normalize(vec3(1.0f, 2.0f, -3.0f));
        const vec3 side = glm::normalize(glm::cross(l, vec3(0.0f, 1.0f, 0.0f)));
        const double sine = std::sqrt(1.0 - cosine * cosine);
        return irradiance_of_sh9(sh9_of_light(l), l * float(cosine) + side * float(sine)).x;
    };
    CHECK(E(1.0) == doctest::Approx(1.0625).epsilon(1e-6));
    CHECK(std::abs(E(0.0) - 0.09375) < 1e-6);
    CHECK(std::abs(E(-1.0) - 0.0625) < 1e-6);
    CHECK(E(-8.0 / 15.0) == 0.0f);  // -0.0396 without the cut
    for (int i = -10; i <= 10; ++i) {
        const double c = 0.1 * i;
        CHECK(std::abs(E(c) - std::max(0.0, 0.25 + 0.5 * c + 5.0 / 32.0 * (3.0 * c * c - 1.0))) < 1e-6);
    }
}

TEST_CASE("SH9: the projection of one bright texel is that texel as a light") {
    const CubeMap map = one_texel(64, 5, 3, 50, vec3(1000.0f));
    const double power = 1000.0 * texel_solid_angle(64, 3, 50);
    const Sh9 projected = project_to_sh9(map);
    const Sh9 light = sh9_of_light(texel_direction(64, 5, 3, 50));
    for (std::size_t k = 0; k < 9; ++k) CHECK(std::abs(projected.c[k].x - power * light.c[k].x) < 1e-6 * power);
}

TEST_CASE("SH9: constant light is pi L for every normal") {
    const Sh9 sh = project_to_sh9(even_light(64, vec3(2.0f)));
    for (const vec3& n : kNormals) {  // the midpoint rule of each texel: O(1 / N^2)
        CHECK(irradiance_of_sh9(sh, glm::normalize(n)).x == doctest::Approx(2.0 * pi).epsilon(1e-4));
    }
}
