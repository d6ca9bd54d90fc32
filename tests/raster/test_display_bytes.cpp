// Radiance straight to bytes: the same as developing the film and rounding it afterwards.
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "raster/display_bytes.hpp"

using namespace kreda::raster;

namespace {

/// Radiances of all sizes, and those that no display can show.
std::vector<float> radiances() {
    std::vector<float> values = {0.0f, -0.0f, -1.0f, 1.0f, 1e30f, -1e-30f};
    for (const float odd : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
        values.push_back(odd);
        values.push_back(-odd);
    }
    for (std::uint32_t bits = 0x38000000u; bits < 0x42000000u; bits += 33331) {
        values.push_back(std::bit_cast<float>(bits));
    }
    return values;
}

std::vector<FilmSettings> settings_to_show() {
    std::vector<FilmSettings> all;
    for (const ToneMap tone_map : {ToneMap::none, ToneMap::reinhard, ToneMap::reinhard_extended}) {
        for (const Transfer transfer : {Transfer::srgb, Transfer::gamma, Transfer::linear}) {
            all.push_back({1.7f, tone_map, 3.0f, transfer, 1.9f});
        }
    }
    return all;
}

}  // namespace

TEST_CASE("bytes of a row are the developed values in 255ths, the nearest, for all tone maps and transfer functions") {
    const std::vector<float> values = radiances();
    const int count = static_cast<int>(values.size());
    const float* const row[3] = {values.data(), values.data(), values.data()};
    for (const FilmSettings& settings : settings_to_show()) {
        std::vector<std::uint8_t> rgb(3 * values.size(), 77);
        ShownValues shown;
        show_row(row, count, settings, rgb.data(), shown);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const long nearest = std::lround(255.0f * display_value(values[i], settings));
            for (std::size_t c = 0; c < 3; ++c) REQUIRE(rgb[3 * i + c] == nearest);
        }
    }
}

TEST_CASE("what no display can show is counted as a developed film counts it, once a component") {
    const std::vector<float> values = radiances();
    const float* const row[3] = {values.data(), values.data(), values.data()};
    std::vector<std::uint8_t> rgb(3 * values.size());
    ShownValues shown;
    show_row(row, static_cast<int>(values.size()), {}, rgb.data(), shown);
    CHECK(shown.report.not_a_number == 3 * 2);
    CHECK(shown.report.infinite == 3 * 2);
    CHECK(shown.report.negative == 3 * 2);
    CHECK(shown.any_light);
}

TEST_CASE("a row is black where every value is 0, of either sign") {
    const float black[2] = {0.0f, -0.0f}, dim[2] = {0.0f, 1e-30f};
    std::uint8_t rgb[6];
    ShownValues shown;
    const float* const dark[3] = {black, black, black};
    show_row(dark, 2, {}, rgb, shown);
    CHECK(!shown.any_light);
    const float* const blue[3] = {black, black, dim};
    show_row(blue, 2, {}, rgb, shown);
    CHECK(shown.any_light);
}
