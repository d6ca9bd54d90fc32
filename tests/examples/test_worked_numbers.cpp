// Numbers that the pages work out in a sentence, worked out again from what the sentence says.
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "course.hpp"
#include "raster/film.hpp"

using namespace kreda::tests;
using std::numbers::pi;

namespace {

double degrees(double radians) {
    return 180.0 / pi * radians;
}

}  // namespace

TEST_CASE("pages: numbers worked out in a sentence are what the sentence works out") {
    struct Worked {
        const char* page;
        const char* key;
        double value;
    };
    const double z2 = 1.0 - 0.25 * 0.25;  // 25: n_z^2 a quarter of the radius outward
    const Worked worked[] = {
        {"13_perspective", "scale", 5.98183e-11 * 0.368871},
        {"16_antialiasing", "mean", (0.887923 + 3.0 * 0.0144438) / 4.0},
        {"17_textures", "blend", (1.0 - 0.170706) * 0.0556363 + 0.170706 * 0.144179},
        {"20_lights", "cos_outer", std::cos(32.0 * pi / 180.0)},
        {"21_lambert", "byte", 255.0 * double{kreda::raster::srgb_from_linear(0.4f)}},
        {"23_blinn_phong", "blinn_angle", degrees(std::acos(0.978625))},
        {"23_blinn_phong", "phong_angle", degrees(std::acos(0.92185))},
        {"23_blinn_phong", "power", std::pow(0.978625, 24.0)},
        {"25_exponents", "n_z", std::sqrt(z2)},
        {"25_exponents", "quarter", 2.0 * z2 - 1.0},
        {"30_fog", "depth_one", 1.0 / 0.15},
        {"31_fog_distance", "cosine", std::cos(40.0 * pi / 180.0)},
        {"32_fog_per_vertex", "below", std::exp(-0.12 * 1.6)},
        {"42_cook_torrance", "ggx_peak", 1.0 / (pi * std::pow(0.2, 4.0))},
        {"44_materials", "as_srgb", double{kreda::raster::linear_from_srgb(82.0f / 255.0f)}},
        {"45_other_models", "steps", std::pow(0.5 / 0.08, 2.0)},
        {"61_acne_and_bias", "biased", 1.06657 - 2.0 * 0.00311015 - 0.000769005},
        {"63_soft_shadows", "penumbra", 0.2 * (1.17371 - 0.0904759)},
        {"65_shadow_volumes", "sheets", std::fmod(300.0, 256.0)},
        {"70_hdr_tone_mapping", "lamp", 60.0 / (1.0 + 60.0)},
        {"71_gamma", "encoded", double{kreda::raster::srgb_from_linear(0.5f)}},
    };
    for (const Worked& w : worked) {
        CAPTURE(std::string(w.page));
        CAPTURE(std::string(w.key));
        CAPTURE(w.value);
        CHECK(rounds_to(w.value, quoted_number(w.page, w.key)));
    }
}

TEST_CASE("25_exponents: the page's angles are where the power falls to one half") {
    const std::vector<QuotedNumber> angles = documented_row("25_exponents", "| h |", "ρ½");
    REQUIRE(angles.size() == 6);
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double h = std::pow(4.0, static_cast<double>(i));
        CHECK(rounds_to(degrees(std::acos(std::pow(0.5, 1.0 / h))), angles[i]));
    }
}
