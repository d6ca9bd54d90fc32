// 94_environment_samples: the numbers of samples on the page are enough, and a quarter of them is not.
#include <cmath>

#include <doctest/doctest.h>

#include "course.hpp"
#include "environment_rays.hpp"
#include "lighting/environment/environment_image.hpp"
#include "lighting/environment/prefilter.hpp"
#include "tools/measure/irradiance_error.hpp"
#include "tools/measure/prefilter_levels.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

/// Mean error in percent over 200 directions and three colours, against the lobe's integral in double.
double error_percent(const lighting::CubeMap& radiance, const std::vector<glm::dvec3>& exact, float alpha,
                     int samples) {
    std::vector<glm::vec3> normals;
    for (const glm::dvec3& n : even_directions(static_cast<int>(exact.size()))) normals.emplace_back(n);
    const std::vector<glm::vec3> colors = prefiltered_radiance(radiance, normals, alpha, samples);
    double error = 0.0, light = 0.0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            error += std::abs(double{colors[i][c]} - exact[i][c]);
            light += exact[i][c];
        }
    }
    return 100.0 * error / light;
}

void check_needed(lighting::Sky sky, int samples) {
    CAPTURE(samples);
    const lighting::CubeMap radiance = lighting::cube_from_sky(sky, 64);
    const std::vector<Ray> rays = rays_of_sky(sky, 512);
    std::vector<glm::dvec3> exact;
    for (const glm::dvec3& n : even_directions(200)) exact.push_back(lobe_average(rays, n, 0.25));
    // 1 % by the program's 384 directions; these are 200 others, and the sky itself, not its cube of 64 texels a side.
    CHECK(error_percent(radiance, exact, 0.25f, samples) < 1.3);
    CHECK(error_percent(radiance, exact, 0.25f, samples / 4) > 1.1);
}

}  // namespace

namespace {

/// A sky and its exact blur at alpha 1/8, 1/4, 1/2, 1, as the example takes them.
struct Blurs {
    explicit Blurs(lighting::Sky sky) : radiance(lighting::cube_from_sky(sky, 64)) {
        for (const float alpha : kAlphas) exact.push_back(tools::exact_level(radiance, alpha, 8));
    }
    double percent(const lighting::CubeMap& from, std::size_t i, int samples) const {
        return 100.0 * tools::map_error(tools::sampled_level(from, kAlphas[i], samples, 8), exact[i]).mean;
    }
    static constexpr float kAlphas[] = {0.125f, 0.25f, 0.5f, 1.0f};
    lighting::CubeMap radiance;
    std::vector<lighting::CubeMap> exact;
};

constexpr std::pair<const char*, lighting::Sky> kSkies[] = {{"`gradient`, a soft sun", lighting::Sky::gradient},
                                                            {"`studio`, lamps", lighting::Sky::studio},
                                                            {"`sunset`, a small sun", lighting::Sky::sunset}};

}  // namespace

TEST_CASE("94_environment_samples: the page's counts are the least powers of two that reach one percent") {
    for (const auto& [row, sky] : kSkies) {
        CAPTURE(std::string(row));
        const Blurs blurs(sky);
        const std::vector<QuotedNumber> quoted = documented_row("94_environment_samples", "samples for 1 %", row);
        REQUIRE(quoted.size() == 8);  // from mips and (plain), four times
        const lighting::CubeMap plain = tools::without_mips(blurs.radiance);
        for (std::size_t i = 0; i < quoted.size(); ++i) {
            const lighting::CubeMap& from = i % 2 == 0 ? blurs.radiance : plain;
            const int samples = static_cast<int>(quoted[i].value);
            CAPTURE(samples);
            CHECK(blurs.percent(from, i / 2, samples) <= 1.0);
            CHECK(blurs.percent(from, i / 2, samples / 2) > 1.0);
        }
    }
}

TEST_CASE("94_environment_samples: the errors beside the times are the mean of levels 4 to 7") {
    for (const int samples : {128, 512, 2048}) {
        const std::string row = std::to_string(samples) + (samples == 2048 ? ", the default" : "");
        const std::vector<QuotedNumber> quoted = documented_row("94_environment_samples", "of level 7", row);
        REQUIRE(quoted.size() >= 4);  // time, and the errors of three skies
        for (std::size_t s = 0; s < 3; ++s) {
            const Blurs blurs(kSkies[s].second);
            double sum = 0.0;
            for (std::size_t i = 0; i < 4; ++i) {
                const int share = std::max(32, static_cast<int>(static_cast<float>(samples) * Blurs::kAlphas[i]));
                sum += blurs.percent(blurs.radiance, i, share) / 4.0;
            }
            CAPTURE(sum);
            CHECK(rounds_to(sum, quoted[quoted.size() - 3 + s]));
        }
    }
}

TEST_CASE("94_environment_samples: so many samples are enough for one percent and a quarter of them is not") {
    check_needed(lighting::Sky::studio, 256);
    check_needed(lighting::Sky::sunset, 2048);
}
