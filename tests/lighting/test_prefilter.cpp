// Prefiltered levels: constant light stays constant, and one bright texel is seen as the analytic GGX lobe.
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "lighting/environment/prefilter.hpp"
#include "tests/lighting/even_light.hpp"

using namespace kreda::lighting;
using glm::vec3;
using kreda::tests::even_light;
using std::numbers::pi;

namespace {

/// (n.l) D(h) / 4 with v = n, in double; mu = n.l, so that n.h^2 = (1 + mu) / 2.        Walter et al. 2007 eq. (33)
double lobe(double mu, double alpha) {
    const double c2 = 0.5 * (1.0 + mu), a2 = alpha * alpha;
    const double q = c2 * (a2 - 1.0) + 1.0;
    return mu * a2 / (4.0 * pi * q * q);
}

/// 2 pi int lobe dmu by the rule of the middle.
double lobe_integral(double alpha) {
    constexpr int kSteps = 200000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) sum += lobe((i + 0.5) / kSteps, alpha);
    return 2.0 * pi * sum / kSteps;
}

}  // namespace

TEST_CASE("prefilter: alpha and level are inverse and alpha doubles") {
    CHECK(alpha_of_level(7) == 1.0f);
    CHECK(alpha_of_level(1) == 1.0f / 64.0f);
    for (int level = 0; level < kPrefilterLevels; ++level) {
        CHECK(level_of_alpha(alpha_of_level(level)) == doctest::Approx(level).epsilon(1e-6));
    }
}

TEST_CASE("prefilter: constant light stays constant at every level") {
    PrefilterSettings settings;
    settings.samples = 256;
    const CubeMap map = prefilter(even_light(32, vec3(0.5f, 1.0f, 8.0f)), settings);
    REQUIRE(map.last_level() == kPrefilterLevels - 1);
    for (int level = 0; level <= map.last_level(); ++level) {
        const vec3 seen = sample_level(map, level, {0.3f, -0.5f, 0.7f});
        CHECK(seen.x == doctest::Approx(0.5).epsilon(2e-6));  // sums of some hundred floats
        CHECK(seen.y == doctest::Approx(1.0).epsilon(2e-6));
        CHECK(seen.z == doctest::Approx(8.0).epsilon(2e-6));
    }
}

TEST_CASE("prefilter: level 0 is the environment itself") {
    CubeMap radiance = even_light(32, vec3(0.1f));
    radiance.set_texel(0, 4, 9, 11, vec3(50.0f));
    const CubeMap map = prefilter(radiance, {});
    CHECK(map.texel(0, 4, 9, 11) == vec3(50.0f));
    CHECK(map.texel(0, 4, 10, 11) == vec3(0.1f));
}

TEST_CASE("prefilter: one bright texel gives the GGX lobe") {
    constexpr int kSize = 64;
    CubeMap map = even_light(kSize, vec3(0.0f));
    map.set_texel(0, 4, 36, 30, vec3(1000.0f));
    fill_border(map, 0);
    fill_mip_levels(map);
    const vec3 l = glm::normalize(texel_direction(kSize, 4, 36, 30));
    const vec3 side = glm::normalize(glm::cross(l, vec3(0.0f, 1.0f, 0.0f)));
    const double power = 1000.0 * texel_solid_angle(kSize, 36, 30);
    for (const float alpha : {0.25f, 0.5f, 1.0f}) {
        const double total = lobe_integral(alpha);
        const double peak = power * lobe(1.0, alpha) / total;
        for (const float turns : {0.0f, 0.02f, 0.05f, 0.1f, 0.15f}) {
            CAPTURE(alpha);
            CAPTURE(turns);
            const double angle = 2.0 * pi * double(turns);
            const vec3 n = l * float(std::cos(angle)) + side * float(std::sin(angle));
            const double want = power * lobe(std::cos(angle), alpha) / total;
            // Samples of a mip level whose texels fit their distance: a texel that is as small as that is met by a
            // handful of them, 15 % of the peak. With many more the lobe itself is left.
            CHECK(std::abs(prefiltered_radiance(map, n, alpha, 1024).x - want) < 0.15 * peak);
            CHECK(std::abs(prefiltered_radiance(map, n, alpha, 131072).x - want) < 0.02 * peak);
        }
    }
}
