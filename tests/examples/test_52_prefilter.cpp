// 52_prefilter: the lobe's integral in double over the sky, what a symmetric blur keeps, and the pictures of both ways
// to sample.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "course.hpp"
#include "environment_rays.hpp"
#include "lighting/environment/environment_image.hpp"
#include "lighting/environment/prefilter.hpp"
#include "tools/measure/irradiance_error.hpp"
#include "tools/measure/prefilter_levels.hpp"

using namespace kreda;
using namespace kreda::tests;
using glm::dvec3;
using std::numbers::pi;

namespace {

doctest::Approx number_of_52(const std::string& key) {
    return doctest::Approx(documented_number("52_prefilter", key));
}

double mean_difference(const raster::Image& a, const raster::Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.values.size(); ++i) sum += std::abs(double{a.values[i]} - double{b.values[i]});
    return sum / static_cast<double>(a.values.size());
}

}  // namespace

TEST_CASE("52_prefilter: the sample of the page worked by hand") {
    const double alpha2 = 1.0 / 16.0, u = 1.0 / 64.0;  // sample 0 of 32
    const double cos2 = (1.0 - u) / (1.0 + (alpha2 - 1.0) * u), q = cos2 * (alpha2 - 1.0) + 1.0;
    const double p = 0.25 * alpha2 / (pi * q * q), share = 1.0 / (32.0 * p);
    CHECK(2.0 * cos2 - 1.0 == number_of_52("n_dot_l").epsilon(1e-4));
    CHECK(p == number_of_52("density").epsilon(1e-4));
    CHECK(share == number_of_52("share").epsilon(1e-3));
    CHECK(0.5 * std::log2(share / (4.0 * pi / (6.0 * 64.0 * 64.0))) == number_of_52("lod").epsilon(2e-3));
}

TEST_CASE("52_prefilter: the sun of the sunset is so many times as bright as the sky beside it") {
    const dvec3 sun = glm::normalize(dvec3(0.2, 0.0995, -0.9747));              // lighting/environment/sky.hpp
    const dvec3 beside = glm::normalize(sun + 0.06 * dvec3(0.9747, 0.0, 0.2));  // 3.4 degrees aside, as high
    const auto red = [](const dvec3& d) {
        return double{lighting::sky_radiance(lighting::Sky::sunset, glm::vec3(d)).x};
    };
    CHECK(rounds_to(red(sun) / red(beside), {documented_number("52_prefilter", "sun"), 10.0}));
}

TEST_CASE("52_prefilter: the errors of the page are those against the integral in double") {
    const std::vector<Ray> rays = rays_of_sky(lighting::Sky::sunset, 512);
    const lighting::CubeMap sky = lighting::cube_from_sky(lighting::Sky::sunset, 64);
    lighting::CubeMap plain = sky;
    plain.levels.resize(1);
    std::vector<glm::vec3> normals;
    for (const dvec3& n : even_directions(200)) normals.emplace_back(n);
    const std::vector<glm::vec3> from_mips = prefiltered_radiance(sky, normals, 0.25f, 256);
    const std::vector<glm::vec3> alone = prefiltered_radiance(plain, normals, 0.25f, 256);
    double light = 0.0, error_mips = 0.0, error_alone = 0.0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const double want = lobe_average(rays, dvec3(normals[i]), 0.25).y;
        light += want;
        error_mips += std::abs(double{from_mips[i].y} - want);
        error_alone += std::abs(double{alone[i].y} - want);
    }
    // 200 directions of green alone: the sun's lobe is met by a dozen of them.
    const auto quoted = [](const char* row) { return documented_row("52_prefilter", "mean error", row).at(2).value; };
    CHECK(100.0 * error_mips / light == doctest::Approx(quoted("roughness 0.5, from mips")).epsilon(0.3));
    CHECK(100.0 * error_alone / light == doctest::Approx(quoted("roughness 0.5, plain")).epsilon(0.3));
}

TEST_CASE("52_prefilter: the table of errors holds what so many samples give") {
    const lighting::CubeMap sky = lighting::cube_from_sky(lighting::Sky::sunset, 64);
    const lighting::CubeMap plain = tools::without_mips(sky);
    for (const auto& [roughness, alpha] : {std::pair("roughness 0.5", 0.25f), std::pair("roughness 1", 1.0f)}) {
        const lighting::CubeMap exact = tools::exact_level(sky, alpha, 8);
        for (const bool mips : {false, true}) {
            const std::string row = std::string(roughness) + (mips ? ", from mips" : ", plain");
            CAPTURE(row);
            const std::vector<QuotedNumber> quoted = documented_row("52_prefilter", "mean error on this sky", row);
            REQUIRE(quoted.size() == 5);
            std::size_t cell = 0;
            for (const int samples : {16, 64, 256, 1024, 4096}) {
                const lighting::CubeMap level = tools::sampled_level(mips ? sky : plain, alpha, samples, 8);
                const double percent = 100.0 * tools::map_error(level, exact).mean;
                CAPTURE(percent);
                CHECK(rounds_to(percent, quoted[cell++]));
            }
        }
    }
}

TEST_CASE("52_prefilter: a blur moves light and makes none so every level has the mean of the sky") {
    double mean = 0.0;
    for (const Ray& ray : rays_of_sky(lighting::Sky::sunset, 512)) mean += ray.w * ray.L.y / (4.0 * pi);
    const lighting::CubeMap map = prefilter(lighting::cube_from_sky(lighting::Sky::sunset, 64), {.samples = 512});
    for (int level = 0; level <= map.last_level(); ++level) {
        CAPTURE(level);
        const int size = map.levels[static_cast<std::size_t>(level)].size;
        double sum = 0.0;
        for (int i = 0; i < lighting::kCubeFaces * size * size; ++i) {
            const int face = i / (size * size), x = i % size, y = i / size % size;
            sum += lighting::texel_solid_angle(size, x, y) * double{map.texel(level, face, x, y).y} / (4.0 * pi);
        }
        CHECK(sum == doctest::Approx(mean).epsilon(0.02));  // samples, and a sun of twelve texels
    }
}

TEST_CASE("52_prefilter: in the picture samples from mips are near the integral and plain ones are not") {
    const auto panel = [](int i) { return linear_panel("52_prefilter/fireflies", 3, 2, i); };
    const auto above_caption = [&](int i) {
        raster::Image image = panel(i);
        for (int y = 54; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) image.set_rgb(x, y, glm::vec3(0.0f));
        }
        return image;
    };
    const raster::Image exact = above_caption(3);
    CHECK(mean_difference(above_caption(1), exact) > 3.0 * mean_difference(above_caption(4), exact));  // 0.0119, 0.0037
    CHECK(mean_difference(above_caption(2), exact) > 3.0 * mean_difference(above_caption(5), exact));  // 0.0027, 0.0007
}
