// The pictures of 70_hdr_tone_mapping and 71_gamma against the operators worked by hand.
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "course.hpp"
#include "raster/film.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

constexpr float kCode = 2.3f / 255.0f;  ///< one code of sRGB's 8 bits near white, in linear light

}  // namespace

TEST_CASE("70_hdr_tone_mapping: every panel is the operator applied to the radiance of the second") {
    const auto panel = [](int i) { return linear_panel("70_hdr_tone_mapping/tone_mapping", 3, 2, i); };
    const raster::Image dark = panel(0), plain = panel(1), reinhard = panel(3), extended = panel(4);
    int compared = 0;
    for (int y = 0; y < 72; ++y) {  // above the captions
        for (int x = 0; x < plain.width; ++x) {
            const float L = plain.at(1, x, y);
            if (L > 0.95f) continue;  // exposure 1 clamps there
            ++compared;
            CHECK(std::abs(dark.at(1, x, y) - 0.15f * L) < kCode);
            CHECK(std::abs(reinhard.at(1, x, y) - 2.0f * L / (1.0f + 2.0f * L)) < 2.0f * kCode);
            CHECK(std::abs(extended.at(1, x, y) - 2.0f * L * (1.0f + 2.0f * L / 36.0f) / (1.0f + 2.0f * L)) <
                  2.0f * kCode);
        }
    }
    CHECK(compared > 4000);
}

TEST_CASE("70_hdr_tone_mapping: the lamp is white in the extended operator and not in the plain one") {
    const raster::Image plain = linear_panel("70_hdr_tone_mapping/tone_mapping", 3, 2, 3);
    const raster::Image extended = linear_panel("70_hdr_tone_mapping/tone_mapping", 3, 2, 4);
    const glm::vec3 lamp(30.0f, 24.6f, 16.5f);  // twice that after the exposure
    const glm::vec3 shown = plain.rgb(8, 23);
    for (int c = 0; c < 3; ++c) CHECK(std::abs(shown[c] - 2.0f * lamp[c] / (1.0f + 2.0f * lamp[c])) < kCode);
    CHECK(extended.rgb(8, 23) == glm::vec3(1.0f));
    CHECK(raster::reinhard(4.0f) == doctest::Approx(documented_number("70_hdr_tone_mapping", "four")));
    CHECK(raster::reinhard_extended(1.0f, 4.0f) ==
          doctest::Approx(documented_number("70_hdr_tone_mapping", "one")).epsilon(1e-3));
}

TEST_CASE("71_gamma: the encoded window sends as much light as the checkerboard around it") {
    const raster::Image panel = linear_panel("71_gamma/gamma", 2, 2, 0);
    double checkerboard = 0.0;
    for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 100; ++x) checkerboard += panel.at(1, x, y) / 1000.0;
    }
    CHECK(checkerboard == doctest::Approx(0.5));
    CHECK(std::abs(panel.at(1, panel.width * 29 / 40, panel.height * 4 / 10) - checkerboard) < kCode);
    CHECK(std::abs(panel.at(1, panel.width * 11 / 40, panel.height * 4 / 10) - documented_number("71_gamma", "srgb")) <
          kCode);
}

TEST_CASE("71_gamma: the numbers of the page") {
    CHECK(std::pow(0.5, 2.2) == doctest::Approx(documented_number("71_gamma", "as_it_is")).epsilon(2e-3));
    const double encoded = 1.055 * std::pow(0.5, 1.0 / 2.4) - 0.055;
    CHECK(std::lround(255.0 * encoded) == documented_number("71_gamma", "code"));
    int plain = 0, dark = 0;  // codes that stand for less than a tenth of the light
    for (int i = 0; i < 256; ++i) {
        const double x = i / 255.0;
        plain += x < 0.1;
        dark += (x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4)) < 0.1;
    }
    CHECK(plain == documented_number("71_gamma", "dark_plain"));
    CHECK(dark == documented_number("71_gamma", "dark_encoded"));
}

TEST_CASE("71_gamma: the steps of light are even where they are encoded and not where they are written as they are") {
    const raster::Image panel = linear_panel("71_gamma/gamma", 2, 2, 1);
    for (int i = 0; i < 12; ++i) {
        CAPTURE(i);
        const int x = (2 * i + 1) * panel.width / 24;
        const double light = i / 11.0;
        CHECK(std::abs(panel.at(0, x, panel.height * 9 / 10) - light) < kCode);
        const double as_it_is = light <= 0.04045 ? light / 12.92 : std::pow((light + 0.055) / 1.055, 2.4);
        CHECK(std::abs(panel.at(0, x, panel.height * 4 / 10) - as_it_is) < kCode);
    }
}
