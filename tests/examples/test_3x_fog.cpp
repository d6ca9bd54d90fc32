// The pictures of 30_fog to 32_fog_per_vertex against numbers worked by hand.
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "course.hpp"
#include "examples/draw.hpp"
#include "lighting/fog.hpp"
#include "raster/camera.hpp"
#include "raster/film.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

double difference(const raster::Image& a, const raster::Image& b) {
    double sum = 0.0;
    for (int y = 0; y < a.height - 20; ++y) {  // above the captions
        for (int x = 0; x < a.width; ++x) sum += glm::distance(a.rgb(x, y), b.rgb(x, y));
    }
    return sum / (a.width * (a.height - 20));
}

}  // namespace

TEST_CASE("30_fog: the lecture's numbers") {
    CHECK(repository_text("examples/30_fog/main.cpp").find("kStart = 2.0f, kEnd = 12.0f, kDensity = 0.15f") !=
          std::string::npos);
    CHECK(lighting::fog_linear(7.0f, 2.0f, 12.0f) == documented_number("30_fog", "linear"));
    CHECK(lighting::fog_exp(7.0f, 0.15f) == doctest::Approx(documented_number("30_fog", "exp")).epsilon(1e-3));
    CHECK(lighting::fog_exp2(7.0f, 0.15f) == doctest::Approx(documented_number("30_fog", "exp2")).epsilon(1e-3));
    CHECK(lighting::fog_exp(2.0f, 0.5f) == doctest::Approx(std::exp(-1.0)).epsilon(1e-6));
}

TEST_CASE("30_fog: the far ground has the colour of the fog and linear fog reaches it") {
    const glm::vec3 mist = examples::srgb(0x9fb2bd);
    for (int i = 0; i < 3; ++i) {
        CAPTURE(i);
        CHECK(glm::distance(linear_panel("30_fog/fog", 2, 2, i).rgb(80, 2), mist) <
              0.01f);  // one code of 255 is 0.006 here
    }
}

TEST_CASE("31_fog_distance: radial fog does not care where the camera looks and planar fog does") {
    // The point of the red ball that is nearest to the eye, before and after a turn by 40 degrees. The eye stays where
    // it is.
    const glm::vec3 eye(0.0f, 0.6f, 0.0f), ball(0.0f, 0.0f, -5.0f);
    const glm::vec3 p = ball + 0.5f * glm::normalize(eye - ball);
    const auto color = [&](int index, double turn_deg) {
        raster::Camera camera;
        camera.position = eye;
        const double turn = glm::radians(turn_deg);
        camera.target = eye + glm::vec3(std::sin(turn), -0.06, -std::cos(turn));
        camera.vertical_fov_deg = 60.0f;
        const raster::Image image = linear_panel("31_fog_distance/distance", 2, 2, index);
        const glm::vec4 clip =
            raster::clip_from_world(camera, float(image.width) / float(image.height)) * glm::vec4(p, 1.0f);
        const int x = static_cast<int>((clip.x / clip.w + 1.0f) * 0.5f * float(image.width));
        const int y = static_cast<int>((1.0f - clip.y / clip.w) * 0.5f * float(image.height));
        return image.rgb(x, y);
    };
    CHECK(glm::distance(color(2, 0), color(3, 40)) < 0.02f);  // the pixel grid falls a little differently on the ball
    CHECK(glm::distance(color(0, 0), color(1, 40)) > 0.06f);
    CHECK(5.0 * std::cos(glm::radians(40.0)) ==
          doctest::Approx(documented_number("31_fog_distance", "planar")).epsilon(1e-3));
}

TEST_CASE("32_fog_per_vertex: a fine ground comes near to fog per pixel and a coarse one does not") {
    const raster::Image coarse = linear_panel("32_fog_per_vertex/frequency", 3, 1, 0);
    const raster::Image fine = linear_panel("32_fog_per_vertex/frequency", 3, 1, 1);
    const raster::Image pixel = linear_panel("32_fog_per_vertex/frequency", 3, 1, 2);
    CHECK(difference(fine, pixel) < 0.25 * difference(coarse, pixel));
}

TEST_CASE("32_fog_per_vertex: the chord over one unit of optical depth is off by less than the bound") {
    const double bound = documented_number("32_fog_per_vertex", "bound");
    double worst = 0.0;
    for (int i = 0; i <= 1000; ++i) {
        const double t = i / 1000.0;
        worst = std::max(worst, (1.0 - t) + t * std::exp(-1.0) - std::exp(-t));
    }
    CHECK(worst < bound);
    CHECK(worst > 0.5 * bound);
}
