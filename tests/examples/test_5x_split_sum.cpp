// The pictures of 53_brdf_map, 54_split_sum and 55_views against sums over the sky itself and against each other.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "course.hpp"
#include "lighting/sky.hpp"
#include "scene/read_scene.hpp"
#include "scene/render.hpp"

using namespace kreda;
using namespace kreda::tests;
using std::numbers::pi;

namespace {

/// Views of the scene of 55_views, one sample a pixel: small, but every material covers hundreds of pixels.
struct Views {
    explicit Views(const std::vector<const char*>& names)
        : scene(scene::read_scene(KREDA_SOURCE_DIR "/examples/55_views/views.toml")) {
        scene.image.width = 96;
        scene.image.height = 54;
        scene.image.samples = 1;
        std::vector<const scene::View*> views;
        for (const char* name : names) views.push_back(scene::find_view(name));
        render(scene, make_plan(scene, views), buffers);
    }
    glm::vec3 at(std::size_t view, int x, int y) const {
        const raster::Image& image = buffers.views[view];
        return image.channels == 3 ? image.rgb(x, y) : glm::vec3(image.at(0, x, y));
    }

    scene::Scene scene;
    scene::RenderBuffers buffers;
};

bool close(const glm::vec3& a, const glm::vec3& b) {
    return glm::distance(a, b) <= 1e-5f * glm::length(b) + 1e-7f;  // a handful of roundings in float
}

/// int L(l) max(n.l, 0) dl over the sky's formula, turned by the scene's rotation about +y: a grid of 0.5 degrees.
glm::dvec3 irradiance_of_sky(const scene::EnvironmentSettings& settings, const glm::dvec3& n) {
    constexpr int kRows = 360;
    const double turn = settings.rotation_deg * pi / 180.0;
    glm::dvec3 sum(0.0);
    for (int j = 0; j < kRows; ++j) {
        const double theta = (j + 0.5) * pi / kRows;
        for (int i = 0; i < 2 * kRows; ++i) {
            const double phi = (i + 0.5) * pi / kRows;
            const glm::dvec3 in_sky(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
            const glm::dvec3 l(std::cos(turn) * in_sky.x + std::sin(turn) * in_sky.z, in_sky.y,
                               -std::sin(turn) * in_sky.x + std::cos(turn) * in_sky.z);
            const double cosine = glm::dot(n, l);
            if (cosine > 0.0)
                sum += glm::dvec3(sky_radiance(settings.sky, glm::vec3(in_sky))) * (cosine * std::sin(theta));
        }
    }
    return sum * (pi / kRows) * (pi / kRows);
}

}  // namespace

TEST_CASE("55_views: at every pixel the terms multiply and add up to the picture") {
    const Views v({"irradiance", "fresnel", "albedo", "metallic", "prefilter", "brdf", "f0", "environment_diffuse",
                   "environment_specular", "ambient"});
    int seen[2] = {};
    for (int y = 0; y < 54; ++y) {
        for (int x = 0; x < 96; ++x) {
            if (v.at(6, x, y) == glm::vec3(0.0f)) continue;  // F0: the background
            const glm::vec3 E = v.at(0, x, y), F = v.at(1, x, y), c = v.at(2, x, y), P = v.at(4, x, y),
                            F0 = v.at(6, x, y);
            const float metallic = v.at(3, x, y).x, A = v.at(5, x, y).x, B = v.at(5, x, y).y;
            const glm::vec3 diffuse = E * (glm::vec3(1.0f) - F) * (1.0f - metallic) * c / float(pi);
            const glm::vec3 specular = P * (F0 * A + glm::vec3(B));
            REQUIRE(close(v.at(7, x, y), diffuse));
            REQUIRE(close(v.at(8, x, y), specular));
            REQUIRE(close(v.at(9, x, y), diffuse + specular));
            REQUIRE(close(v.buffers.film.rgb(x, y), diffuse + specular));
            ++seen[metallic > 0.5f ? 1 : 0];
        }
    }
    CHECK(seen[0] > 400);
    CHECK(seen[1] > 200);
}

TEST_CASE("55_views: the page multiplies right") {
    CHECK(1.85163 / pi * 0.958645 * 0.62 == doctest::Approx(documented_number("55_views", "diffuse")).epsilon(1e-4));
    CHECK(75.3915 * (0.04 * 0.997808 + 0.00156576) ==
          doctest::Approx(documented_number("55_views", "specular")).epsilon(1e-5));
}

TEST_CASE("55_views: the irradiance is the integral over the sky's formula") {
    const Views v({"normal", "irradiance"});
    for (const glm::ivec2 pixel : {glm::ivec2(70, 27), glm::ivec2(81, 20), glm::ivec2(90, 33)}) {  // on the ball
        CAPTURE(pixel.x);
        const glm::dvec3 E = irradiance_of_sky(v.scene.environment, glm::dvec3(v.at(0, pixel.x, pixel.y)));
        for (int c = 0; c < 3; ++c)
            CHECK(v.at(1, pixel.x, pixel.y)[c] == doctest::Approx(E[c]).epsilon(0.01));  // texels of 1.4 degrees
    }
}

TEST_CASE("55_views: the last column of the sheet adds up") {
    const auto panel = [](int i) { return linear_panel("55_views/sheet.png", 3, 3, i); };
    const raster::Image diffuse = panel(2), specular = panel(5), ambient = panel(8);
    int compared = 0;
    for (int y = 0; y < ambient.height - 14; ++y) {  // above the captions
        for (int x = 0; x < ambient.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                const float sum = diffuse.at(c, x, y) + specular.at(c, x, y);
                if (sum == 0.0f || sum > 0.95f) continue;                           // background, or cut off at white
                CHECK(std::abs(ambient.at(c, x, y) - sum) < 1.6f / 255.0f * 2.3f);  // three bytes of sRGB
                ++compared;
            }
        }
    }
    CHECK(compared > 1500);
}
