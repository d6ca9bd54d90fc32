// The pictures of 20_lights to 25_exponents against numbers worked by hand.
#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "course.hpp"
#include "examples/draw.hpp"
#include "lighting/light.hpp"
#include "lighting/light_sample.hpp"
#include "lighting/reflection.hpp"
#include "raster/film.hpp"
#include "raster/shapes.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

glm::vec3 middle(const raster::Image& image) {
    return image.rgb(image.width / 2, image.height / 2);
}

/// Half a code of sRGB's 8 bits, in linear light near the value x: the slope of the decoding is at most 2.3.
constexpr float kHalfCode = 0.5f / 255.0f * 2.3f;

float brightest_green(const raster::Image& image) {
    return *std::max_element(image.values.begin() + image.width * image.height,
                             image.values.begin() + 2 * image.width * image.height);
}

double sum_of(const raster::Image& image) {
    double sum = 0.0;
    for (int y = 0; y < image.height * 3 / 4; ++y) {  // above the caption
        for (int x = 0; x < image.width; ++x) sum += image.at(0, x, y);
    }
    return sum;
}

}  // namespace

TEST_CASE("20_lights: at twice the distance a physical lamp gives a quarter") {
    const lighting::Attenuation physical{0.0f, 0.0f, 1.0f};
    CHECK(lighting::attenuate(physical, 2.0f) / lighting::attenuate(physical, 1.0f) ==
          doctest::Approx(documented_number("20_lights", "at_two")));
}

TEST_CASE("20_lights: the sun lights the table evenly and outside the cone only ambient light is left") {
    const raster::Image sun = linear_panel("20_lights/lights", 2, 2, 0);
    CHECK(glm::distance(sun.rgb(10, 20), sun.rgb(150, 60)) < 2.0f * kHalfCode);
    const raster::Image spot = linear_panel("20_lights/lights", 2, 2, 3);
    CHECK(glm::distance(spot.rgb(150, 20), 0.15f * examples::kDust) < 2.0f * kHalfCode);
}

TEST_CASE("21_lambert: the wall is 0.8 times the cosine") {
    const int angles[] = {0, 30, 60, 80, 100};
    for (int i = 0; i < 5; ++i) {
        CAPTURE(angles[i]);
        const float cosine = static_cast<float>(std::cos(glm::radians(static_cast<double>(angles[i]))));
        const glm::vec3 expected(0.8f * std::max(cosine, 0.0f));
        CHECK(glm::distance(middle(linear_panel("21_lambert/cosine", 3, 2, i)), expected) < 2.0f * kHalfCode);
    }
    CHECK(0.8 * std::cos(glm::radians(60.0)) == doctest::Approx(documented_number("21_lambert", "at_60")));
}

TEST_CASE("21_lambert: the bytes of half the light under both models") {
    const auto byte = [](double light) { return std::lround(255.0 * (1.055 * std::pow(light, 1.0 / 2.4) - 0.055)); };
    const double pi = 3.14159265358979, cosine = std::cos(27.0 * pi / 180.0);
    const auto documented = [](const char* key) { return documented_number("21_lambert", key); };
    CHECK(byte(0.5) == documented("lambert_byte"));
    CHECK(byte(0.5 / pi) == documented("albedo_byte"));
    CHECK(byte(0.5 * cosine) == documented("lambert_27"));
    CHECK(byte(0.5 * cosine / pi) == documented("albedo_27"));
    CHECK(byte(0.5) == documented_number("42_cook_torrance", "lambert_byte"));
    CHECK(byte(0.5 / pi) == documented_number("42_cook_torrance", "albedo_byte"));
}

TEST_CASE("22_phong_terms: the last picture is the sum of the four others in linear light") {
    const raster::Image sum = linear_panel("22_phong_terms/terms", 3, 2, 4);
    std::vector<raster::Image> term;
    for (int i = 0; i < 4; ++i) term.push_back(linear_panel("22_phong_terms/terms", 3, 2, i));
    int compared = 0;
    for (int y = 0; y < 70; ++y) {  // above the captions
        for (int x = 0; x < sum.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                float terms = 0.0f;
                for (const raster::Image& image : term) terms += image.at(c, x, y);
                if (terms > 0.97f) continue;                                  // clipped at white
                CHECK(std::abs(terms - sum.at(c, x, y)) < 5.0f * kHalfCode);  // five pictures of 8 bits each
                ++compared;
            }
        }
    }
    CHECK(compared > 1000);
    CHECK(std::pow(0.9, 40.0) == doctest::Approx(documented_number("22_phong_terms", "dim")).epsilon(0.02));
}

TEST_CASE("22_phong_terms: yellow light on a violet material is red") {
    CHECK(lighting::ambient_term({1, 1, 0}, {1, 0, 1}) == glm::vec3(1, 0, 0));
    CHECK(lighting::ambient_term({1, 1, 0}, {0, 0, 1}) == glm::vec3(0, 0, 0));
}

TEST_CASE("23_blinn_phong: the matched exponent is nearer to Phong than the same one") {
    const raster::Image same = linear_panel("23_blinn_phong/blinn_phong", 3, 2, 4);
    const raster::Image matched = linear_panel("23_blinn_phong/blinn_phong", 3, 2, 5);
    CHECK(sum_of(matched) < 0.4 * sum_of(same));
    CHECK(lighting::blinn_exponent_matching_phong(24.0f) == documented_number("23_blinn_phong", "matched"));
}

TEST_CASE("24_shading: Gouraud misses the narrow highlight that Phong shows") {
    const float gouraud = brightest_green(linear_panel("24_shading/shading", 3, 2, 4));
    const float phong = brightest_green(linear_panel("24_shading/shading", 3, 2, 5));
    CHECK(phong > gouraud + 0.1f);
    CHECK(raster::make_shape("sphere", 16)->triangle_count() == documented_number("24_shading", "triangles"));
}

TEST_CASE("25_exponents: the highlight falls to one half where the arccosine says") {
    const float pixels_a_unit = 88.0f / 2.4f;
    const double exponents[] = {1, 4, 16, 64};
    for (int i = 0; i < 4; ++i) {
        CAPTURE(exponents[i]);
        const raster::Image image = linear_panel("25_exponents/exponents", 3, 2, i);
        const double rho = std::acos(std::pow(0.5, 1.0 / exponents[i]));  // between v and r: twice the normal's angle
        const double radius = std::sin(0.5 * rho) * pixels_a_unit;
        int x = 52;
        while (x < 103 && image.at(0, x, 44) >= 0.5f) ++x;
        CHECK(x - 52 == doctest::Approx(radius).epsilon(0.02).scale(60.0));  // to about one pixel
    }
}

TEST_CASE("25_exponents: for h = 1 the disc ends where the normal is turned by 45 degrees") {
    const raster::Image image = linear_panel("25_exponents/exponents", 3, 2, 0);
    const double edge = 52 + std::sin(glm::radians(documented_number("25_exponents", "edge"))) * 88.0 / 2.4;
    CHECK(image.at(0, static_cast<int>(edge) - 3, 44) > 0.01f);
    CHECK(image.at(0, static_cast<int>(edge) + 2, 44) == 0.0f);
}
