// 94_environment_samples: the numbers of samples on the page are enough, and a quarter of them is not.
#include <cmath>

#include <doctest/doctest.h>

#include "course.hpp"
#include "environment_rays.hpp"
#include "lighting/environment/environment_image.hpp"
#include "lighting/environment/prefilter.hpp"

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

void check_needed(lighting::Sky sky, const char* key) {
    CAPTURE(std::string(key));
    const int samples = static_cast<int>(documented_number("94_environment_samples", key));
    const lighting::CubeMap radiance = lighting::cube_from_sky(sky, 64);
    const std::vector<Ray> rays = rays_of_sky(sky, 512);
    std::vector<glm::dvec3> exact;
    for (const glm::dvec3& n : even_directions(200)) exact.push_back(lobe_average(rays, n, 0.25));
    // 1 % by the program's 384 directions; these are 200 others, and the sky itself, not its cube of 64 texels a side.
    CHECK(error_percent(radiance, exact, 0.25f, samples) < 1.3);
    CHECK(error_percent(radiance, exact, 0.25f, samples / 4) > 1.1);
}

}  // namespace

TEST_CASE("94_environment_samples: so many samples are enough for one percent and a quarter of them is not") {
    check_needed(lighting::Sky::studio, "studio_mips");
    check_needed(lighting::Sky::sunset, "sunset_mips");
}
