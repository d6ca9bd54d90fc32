// Tone mapping and transfer functions: numbers worked by hand, round trips, and values no display can show.
#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "raster/film.hpp"

using namespace kreda::raster;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();
/// Two or three float roundings of numbers below 1.
constexpr double kRounding = 2e-7;

Image row_of(std::initializer_list<float> values) {
    Image image = make_image(static_cast<int>(values.size()), 1, 1);
    std::copy(values.begin(), values.end(), image.values.begin());
    return image;
}

}  // namespace

TEST_CASE("Reinhard by hand: 0.18 -> 0.18/1.18 and 1 -> 1/2 and 4 -> 4/5") {
    CHECK(std::abs(reinhard(0.18f) - 0.152542373) < kRounding);
    CHECK(reinhard(0.0f) == 0.0f);
    CHECK(reinhard(1.0f) == 0.5f);
    CHECK(std::abs(reinhard(4.0f) - 0.8) < kRounding);
}

TEST_CASE("Reinhard never decreases and never exceeds 1 and infinity gives 1") {
    float before = 0.0f;
    for (float radiance = 1e-6f; radiance < 1e38f; radiance *= 1.01f) {
        const float now = reinhard(radiance);
        REQUIRE(now >= before);
        REQUIRE(now <= 1.0f);
        before = now;
    }
    CHECK(reinhard(3e38f) == 1.0f);
    CHECK(reinhard(kInf) == 1.0f);
}

TEST_CASE("Extended Reinhard by hand: white gives 1 and 1 -> 0.53125 for white 4 and far above white it stays finite") {
    CHECK(reinhard_extended(1.0f, 4.0f) == 0.53125f);  // 1/2 (1 + 1/16)
    for (const float white : {0.5f, 1.0f, 4.0f, 100.0f}) {
        CHECK(std::abs(reinhard_extended(white, white) - 1.0) < kRounding);
    }
    for (const float radiance : {1e10f, 1e19f, 1e30f, kInf}) {
        CHECK(reinhard_extended(radiance, 4.0f) >= 1.0f);
        CHECK(std::isfinite(reinhard_extended(radiance, 4.0f)));
    }
    CHECK(reinhard_extended(0.5f, 1e15f) ==
          doctest::Approx(1.0 / 3.0).epsilon(1e-6));  // a distant white: plain Reinhard
}

TEST_CASE("sRGB by hand: values of IEC 61966-2-1") {
    CHECK(std::abs(srgb_from_linear(0.18f) - 0.46135613) < kRounding);
    CHECK(std::abs(srgb_from_linear(0.5f) - 0.73535698) < kRounding);
    CHECK(std::abs(srgb_from_linear(0.01f) - 0.09985282) < kRounding);
    CHECK(std::abs(srgb_from_linear(0.002f) - 0.02584) < kRounding);  // toe: 12.92 * 0.002
    CHECK(std::abs(linear_from_srgb(0.5f) - 0.2140411405) < kRounding);
    CHECK(std::abs(linear_from_srgb(128.0f / 255.0f) - 0.2158605001) < kRounding);
    CHECK(std::abs(linear_from_srgb(0.02f) - 0.02 / 12.92) < kRounding);
    CHECK(srgb_from_linear(0.0f) == 0.0f);
    CHECK(linear_from_srgb(0.0f) == 0.0f);
    CHECK(std::abs(srgb_from_linear(1.0f) - 1.0) < kRounding);
    CHECK(std::abs(linear_from_srgb(1.0f) - 1.0) < kRounding);
}

TEST_CASE("sRGB against std::pow in double over the whole range") {
    double worst_encoded = 0.0, worst_decoded = 0.0;
    for (int i = 0; i <= 100000; ++i) {
        const float x = static_cast<float>(i) / 100000.0f;
        const double encoded = x <= 0.0031308f ? 12.92 * x : 1.055 * std::pow(double{x}, 1.0 / 2.4) - 0.055;
        const double decoded = x <= 0.04045f ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
        worst_encoded = std::max(worst_encoded, std::abs(srgb_from_linear(x) - encoded));
        worst_decoded = std::max(worst_decoded, std::abs(linear_from_srgb(x) - decoded));
    }
    CHECK(worst_encoded < 2.5e-7);  // pow below 1 ulp, a product and a difference of numbers near 1, half an ulp each
    CHECK(worst_decoded < 2.5e-7);
}

TEST_CASE("sRGB: all 256 codes survive decoding and encoding") {
    for (int code = 0; code < 256; ++code) {
        const float linear = linear_from_srgb(static_cast<float>(code) / 255.0f);
        CHECK(static_cast<int>(std::floor(srgb_from_linear(linear) * 255.0f + 0.5f)) == code);
    }
}

TEST_CASE("Gamma 2.2 by hand: 0.5 -> 0.72974 and back 0.5^2.2 = 0.21764") {
    FilmSettings settings;
    settings.transfer = Transfer::gamma;
    CHECK(std::abs(display_value(0.5f, settings) - 0.72974) < 5e-6);  // five digits given
    CHECK(std::abs(pow(0.5f, 2.2f) - 0.21764) < 5e-6);
    settings.gamma = 2.0f;
    CHECK(display_value(0.25f, settings) == doctest::Approx(0.5).epsilon(2e-7));
    CHECK(display_value(0.0f, settings) == 0.0f);
    CHECK(display_value(1.0f, settings) == 1.0f);
}

TEST_CASE("Order: exposure first and then tone map and then transfer") {
    FilmSettings settings;
    settings.exposure = 4.0f;
    settings.tone_map = ToneMap::reinhard;
    settings.transfer = Transfer::linear;
    CHECK(std::abs(display_value(1.0f, settings) - 0.8) < kRounding);
    settings.transfer = Transfer::srgb;
    CHECK(std::abs(display_value(0.25f, settings) - 0.73535698) < kRounding);  // 0.25 * 4 -> 1/2 -> sRGB
    settings.tone_map = ToneMap::none;
    CHECK(std::abs(display_value(7.0f, settings) - 1.0) < kRounding);  // 1.055f - 0.055f is 0.99999994
}

TEST_CASE("NaN shows as 0 and +infinity as the brightest and negative and -infinity as 0 and each is counted") {
    const Image radiance = row_of({0.5f, kNan, kInf, -kInf, -1.0f, -0.0f, 2.0f, kNan});
    for (const ToneMap tone_map : {ToneMap::none, ToneMap::reinhard, ToneMap::reinhard_extended}) {
        for (const Transfer transfer : {Transfer::srgb, Transfer::gamma, Transfer::linear}) {
            FilmSettings settings;
            settings.tone_map = tone_map;
            settings.transfer = transfer;
            FilmReport report;
            const Image shown = develop(radiance, settings, &report);
            CHECK(shown.values[1] == 0.0f);
            CHECK(std::abs(shown.values[2] - 1.0) < kRounding);
            CHECK(shown.values[3] == 0.0f);
            CHECK(shown.values[4] == 0.0f);
            CHECK(shown.values[5] == 0.0f);
            CHECK_FALSE(std::signbit(shown.values[5]));
            for (const float value : shown.values) CHECK((value >= 0.0f && value <= 1.0f));
            CHECK(report.not_a_number == 2);
            CHECK(report.infinite == 2);
            CHECK(report.negative == 1);
        }
    }
}

TEST_CASE("A whole film is developed as each of its values alone, bit for bit") {
    std::vector<float> values;
    for (std::uint32_t high = 0; high < 1u << 16; high += 5)
        values.push_back(std::bit_cast<float>(high << 16 | 0x1234u));
    Image radiance = make_image(static_cast<int>(values.size()), 1, 1);
    std::copy(values.begin(), values.end(), radiance.values.begin());
    for (const ToneMap tone_map : {ToneMap::none, ToneMap::reinhard, ToneMap::reinhard_extended}) {
        for (const Transfer transfer : {Transfer::srgb, Transfer::gamma, Transfer::linear}) {
            FilmSettings settings;
            settings.exposure = 0.7f;
            settings.tone_map = tone_map;
            settings.transfer = transfer;
            const Image shown = develop(radiance, settings);
            std::size_t differ = 0;
            for (std::size_t i = 0; i < values.size(); ++i) {
                differ += std::bit_cast<std::uint32_t>(shown.values[i]) !=
                          std::bit_cast<std::uint32_t>(display_value(values[i], settings));
            }
            CHECK(differ == 0);
        }
    }
}

TEST_CASE("Every float a film can hold is shown between 0 and 1") {
    FilmSettings settings;
    for (const float exposure : {0.0f, 1e-30f, 1.0f, 1e30f}) {
        for (const ToneMap tone_map : {ToneMap::none, ToneMap::reinhard, ToneMap::reinhard_extended}) {
            settings.exposure = exposure;
            settings.tone_map = tone_map;
            for (std::uint32_t high = 0; high < 1u << 16; ++high) {
                const float radiance = std::bit_cast<float>(high << 16 | 0x1234u);
                const float shown = display_value(radiance, settings);
                if (!(shown >= 0.0f && shown <= 1.0f)) FAIL(radiance << " is shown as " << shown);
            }
        }
    }
}

TEST_CASE("Without non-finite: NaN becomes 0 and infinities the largest float of their sign and the rest stays") {
    FilmReport report;
    const Image clean = without_non_finite(row_of({kNan, kInf, -kInf, -2.0f, 3e38f}), &report);
    CHECK(clean.values[0] == 0.0f);
    CHECK(clean.values[1] == std::numeric_limits<float>::max());
    CHECK(clean.values[2] == -std::numeric_limits<float>::max());
    CHECK(clean.values[3] == -2.0f);
    CHECK(clean.values[4] == 3e38f);
    CHECK(report.not_a_number == 1);
    CHECK(report.infinite == 2);
    CHECK(report.negative == 1);
}
