// 51_irradiance: the picture and the page against sums in double over the skies and over real environments.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "course.hpp"
#include "environment_rays.hpp"
#include "lighting/environment/environment_image.hpp"
#include "lighting/environment/irradiance.hpp"
#include "scene/files/image_file.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tools/measure/irradiance_error.hpp"

using namespace kreda;
using namespace kreda::tests;
using glm::dvec3;
using std::numbers::pi;

namespace {

/// E(n), summed over all rays.
dvec3 irradiance(const std::vector<Ray>& rays, const dvec3& n) {
    dvec3 E(0.0);
    for (const Ray& ray : rays) E += std::max(0.0, glm::dot(n, ray.l)) * ray.w * ray.L;
    return E;
}

/// Error of the polynomial over 100 normals and three colours, relative to all the light from everywhere: what
/// Ramamoorthi & Hanrahan call the total intensity.
struct Sh9Error {
    double mean = 0.0, largest = 0.0;
};

Sh9Error sh9_error(const lighting::CubeMap& radiance, const std::vector<Ray>& rays) {
    const lighting::Sh9 sh = lighting::project_to_sh9(radiance);
    dvec3 total(0.0);
    for (const Ray& ray : rays) total += ray.w * ray.L;
    Sh9Error error;
    const std::vector<dvec3> normals = even_directions(100);
    for (const dvec3& n : normals) {
        const dvec3 difference =
            glm::abs(dvec3(lighting::irradiance_of_sh9(sh, glm::vec3(n))) - irradiance(rays, n)) / total;
        error.mean += (difference.x + difference.y + difference.z) / (3.0 * static_cast<double>(normals.size()));
        error.largest = std::max({error.largest, difference.x, difference.y, difference.z});
    }
    return error;
}

/// What one light gives, the worst of all environments: |1/4 + c/2 + 5/32 (3 c^2 - 1) - max(c, 0)| over all directions.
/// Every environment is a sum of such lights, and so is its error; cutting at 0 only makes it smaller.
Sh9Error error_of_one_light() {
    constexpr int kSteps = 100'000;
    Sh9Error error;
    for (int i = 0; i < kSteps; ++i) {
        const double c = 2.0 * (i + 0.5) / kSteps - 1.0;
        const double difference = std::abs(0.25 + 0.5 * c + 5.0 / 32.0 * (3.0 * c * c - 1.0) - std::max(c, 0.0));
        error.mean += difference / kSteps;
        error.largest = std::max(error.largest, difference);
    }
    return error;
}

/// The page's row of this environment, in percent of all the light.
void check_error_row(const std::string& row, const Sh9Error& error) {
    const std::vector<QuotedNumber> quoted = documented_row("51_irradiance", "largest error", row);
    CAPTURE(row);
    CAPTURE(100.0 * error.mean);
    CAPTURE(100.0 * error.largest);
    CHECK(rounds_to(100.0 * error.mean, quoted.at(0)));
    CHECK(rounds_to(100.0 * error.largest, quoted.at(1)));
}

doctest::Approx number(const std::string& key) {
    return doctest::Approx(documented_number("51_irradiance", key));
}

}  // namespace

TEST_CASE("51_irradiance: the picture shows the light that a sum in double over the sky finds") {
    const raster::Image panel = linear_panel("51_irradiance/irradiance", 3, 2, 0);
    const std::vector<Ray> rays = rays_of_sky(lighting::Sky::studio, 256);
    const int width = 104, height = 52, top = (panel.height - height) / 2;
    for (int y = 3; y < 36; y += 8) {  // above the caption
        for (int x = 5; x < width; x += 20) {
            const dvec3 n = direction_of_angles(2.0 * pi * ((x + 0.5) / width - 0.5), pi * (y + 0.5) / height);
            const dvec3 want = glm::min(0.7 / pi * irradiance(rays, n), 1.0);
            const dvec3 shown = panel.rgb(x, top + y);
            for (int c = 0; c < 3; ++c) CHECK(std::abs(shown[c] - want[c]) < 0.015);  // a map of 16 x 16 texels a face
        }
    }
}

TEST_CASE("51_irradiance: the numbers of the page for the studio are those of a sum in double") {
    const std::vector<Ray> rays = rays_of_sky(lighting::Sky::studio, 1024);
    CHECK(irradiance(rays, {0, 1, 0}).y / pi ==
          number("texels_up").epsilon(2e-3));  // a cube of 64 texels smears the lamps
    CHECK(irradiance(rays, {0, -1, 0}).y / pi == number("texels_down").epsilon(2e-3));
    dvec3 total(0.0);
    for (const Ray& ray : rays) total += ray.w * ray.L;
    CHECK(total.y / 4.0 == number("quarter").epsilon(2e-3));
    const double x = pi / 8.0;
    CHECK(x / std::sin(x) == number("four_angles").epsilon(1e-4));
    CHECK(0.25 + 0.5 + 5.0 / 16.0 == number("one_light"));
}

TEST_CASE("51_irradiance: the table of the four ways holds what they give") {
    const lighting::CubeMap radiance = lighting::cube_from_sky(lighting::Sky::studio, 64);
    const lighting::Sh9 sh = project_to_sh9(radiance);
    const std::pair<const char*, glm::vec3> rows[] = {{"up", {0, 1, 0}}, {"down", {0, -1, 0}}, {"to −z", {0, 0, -1}}};
    for (const auto& [row, n] : rows) {
        CAPTURE(std::string(row));
        const std::vector<float> E = {irradiance_of_texels(radiance, n).y,
                                      irradiance_of_hemisphere(radiance, n, 16, 4).y,
                                      irradiance_of_cosine(radiance, n, 64).y, irradiance_of_sh9(sh, n).y};
        const std::vector<QuotedNumber> quoted = documented_row("51_irradiance", "every texel", row);
        REQUIRE(quoted.size() == E.size());
        for (std::size_t i = 0; i < E.size(); ++i) CHECK(rounds_to(E[i] / pi, quoted[i]));
    }
}

TEST_CASE("51_irradiance: the table of errors holds what maps of 1536 normals give") {
    constexpr int kSize = 16;
    const lighting::CubeMap radiance = lighting::cube_from_sky(lighting::Sky::studio, 64);
    const lighting::CubeMap exact = tools::every_texel(kSize).make(radiance);
    const std::pair<const char*, lighting::IrradianceSum> rows[] = {
        {"double sum: error, time", lighting::IrradianceSum::hemisphere},
        {"cosine-weighted", lighting::IrradianceSum::cosine}};
    for (const auto& [row, sum] : rows) {
        const std::vector<QuotedNumber> quoted = documented_row("51_irradiance", "1536 normals", row);
        std::size_t cell = 0;  // two numbers each: error and time
        for (const tools::IrradianceWay& way : tools::sampling_ways(sum, kSize)) {
            if (way.samples < 64) continue;
            CAPTURE(way.samples);
            CHECK(rounds_to(100.0 * tools::map_error(way.make(radiance), exact).mean, quoted.at(cell)));
            cell += 2;
        }
        if (sum == lighting::IrradianceSum::cosine) {
            const lighting::CubeMap nine = tools::nine_coefficients(kSize).make(radiance);
            CAPTURE(100.0 * tools::map_error(nine, exact).mean);
            CHECK(rounds_to(100.0 * tools::map_error(nine, exact).mean, quoted.at(cell)));
        }
    }
}

TEST_CASE("51_irradiance: nine numbers err on every sky less than on one light") {
    const Sh9Error bound = error_of_one_light();
    CHECK(100.0 * bound.mean == number("bound_mean").epsilon(2e-3));
    CHECK(100.0 * bound.largest == number("bound_most").epsilon(2e-3));
    for (const auto& [sky, name] :
         {std::pair(lighting::Sky::gradient, "gradient"), std::pair(lighting::Sky::studio, "studio"),
          std::pair(lighting::Sky::sunset, "sunset")}) {
        CAPTURE(std::string(name));
        const Sh9Error error = sh9_error(lighting::cube_from_sky(sky, 64), rays_of_sky(sky, 512));
        CHECK(error.mean < bound.mean);
        CHECK(error.largest < bound.largest);
        check_error_row("`" + std::string(name) + "`", error);
    }
}

TEST_CASE("51_irradiance: nine numbers on real environments") {
    const std::string data = shared_data_folder();
    if (data.empty()) {
        MESSAGE("SKIPPED: no folder of shared data (set KREDA_SHARED)");
        return;
    }
    const Sh9Error bound = error_of_one_light();
    const std::pair<const char*, const char*> files[] = {
        {"dawn.hdr", "dawn over a plain (Poly Haven, kiara_1_dawn)"},
        {"studio.exr", "a studio with small lamps (Poly Haven, as Blender has it)"},
        {"city.exr", "a city under clouds (Poly Haven)"}};
    for (const auto& [name, row] : files) {
        raster::Image image = scene::read_image(data + "/" + std::string(name));
        lighting::repair_environment(image);
        const auto rays = rays_of(image.width, [&](int x, int y, const dvec3&) { return dvec3(image.rgb(x, y)); });
        const lighting::CubeMap radiance = lighting::cube_from_equirect(image, 256);
        const Sh9Error error = sh9_error(radiance, rays);
        MESSAGE(std::string(name), ": mean ", 100.0 * error.mean, " %, at most ", 100.0 * error.largest,
                " % of all the light");
        CHECK(error.mean < bound.mean);
        CHECK(error.largest < bound.largest);
        check_error_row(row, error);
    }
}
