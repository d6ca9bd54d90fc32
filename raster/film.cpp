#include "raster/film.hpp"

#include <algorithm>
#include <cmath>

#include "raster/display_bytes.hpp"
#include "raster/platform.hpp"

namespace kreda::raster {

namespace {

/// From radiance to what a display is sent, 0..1. NaN becomes 0.
template <class ToneMapFormula, class TransferFormula>
float developed(float radiance, float exposure, ToneMapFormula tone_map, TransferFormula encode) {
    const float scaled = radiance * exposure;
    const float exposed = scaled > 0.0f ? scaled : 0.0f;
    const float mapped = saturate(tone_map(exposed));
    return saturate(encode(mapped));
}

/// use(formula) of the tone map that was chosen.
template <class Use>
auto with_tone_map(const FilmSettings& settings, Use use) {
    switch (settings.tone_map) {
        case ToneMap::reinhard: return use([](float L) { return reinhard(L); });
        case ToneMap::reinhard_extended:
            return use([white = settings.white](float L) { return reinhard_extended(L, white); });
        default: return use([](float L) { return L; });
    }
}

/// use(formula) of the transfer function that was chosen.
template <class Use>
auto with_transfer(const FilmSettings& settings, Use use) {
    switch (settings.transfer) {
        case Transfer::srgb: return use([](float x) { return srgb_from_linear(x); });
        case Transfer::gamma: return use([gamma = settings.gamma](float x) { return pow(x, 1.0f / gamma); });
        default: return use([](float x) { return x; });
    }
}

/// use(tone_map, encode)
template <class Use>
auto with_film_formulas(const FilmSettings& settings, Use use) {
    return with_tone_map(settings, [&](auto tone_map) {
        return with_transfer(settings, [&](auto encode) { return use(tone_map, encode); });
    });
}

/// What is chosen is asked once, not at each value: the loop becomes one over many lanes.
KREDA_BATCH_LOOP void develop_values(const float* __restrict radiance, int lanes, const FilmSettings& settings,
                                     float* __restrict display) {
    with_film_formulas(settings, [=, exposure = settings.exposure](auto tone_map, auto encode) {
        for (int i = 0; i < lanes; ++i) {  // 6 formulas: those with gamma, whose power is known late, stay scalar
            display[i] = developed(radiance[i], exposure, tone_map, encode);
        }
    });
}

/// How many values are NaN, infinite or negative.
KREDA_BATCH_LOOP int odd_values(const float* radiance, int lanes) {
    int odd = 0;
    for (int i = 0; i < lanes; ++i) odd += radiance[i] >= 0.0f && radiance[i] <= kMaxFinite ? 0 : 1;
    return odd;
}

/// How many values are not 0.
KREDA_BATCH_LOOP int lit_values(const float* radiance, int lanes) {
    int lit = 0;
    for (int i = 0; i < lanes; ++i) lit += radiance[i] == 0.0f ? 0 : 1;
    return lit;
}

void count(float value, FilmReport& report) {
    report.not_a_number += std::isnan(value) ? 1 : 0;
    report.infinite += std::isinf(value) ? 1 : 0;
    report.negative += value < 0.0f && std::isfinite(value) ? 1 : 0;
}

/// round(255 x), half up; x in 0..1.
std::uint8_t nearest_byte(float x) {
    return static_cast<std::uint8_t>(round_half_up_to_int(255.0f * x));
}

void note(const float* radiance, int lanes, ShownValues& shown) {
    shown.any_light |= lit_values(radiance, lanes) > 0;
    if (odd_values(radiance, lanes) == 0) return;
    for (int i = 0; i < lanes; ++i) count(radiance[i], shown.report);  // not vectorized: rare
}

}  // namespace

float display_value(float radiance, const FilmSettings& settings) {
    return with_film_formulas(
        settings, [&](auto tone_map, auto encode) { return developed(radiance, settings.exposure, tone_map, encode); });
}

void add(const ShownValues& more, ShownValues& shown) {
    shown.any_light |= more.any_light;
    shown.report.not_a_number += more.report.not_a_number;
    shown.report.infinite += more.report.infinite;
    shown.report.negative += more.report.negative;
}

void show_row(const float* const radiance[3], int count, const FilmSettings& settings, std::uint8_t* rgb,
              ShownValues& shown) {
    constexpr int kPiece = 64;
    for (int c = 0; c < 3; ++c) note(radiance[c], count, shown);
    for (int first = 0; first < count; first += kPiece) {
        const int pixels = std::min(count - first, kPiece);
        float display[3][kPiece];
        for (int c = 0; c < 3; ++c) develop_values(radiance[c] + first, pixels, settings, display[c]);
        for (int i = 0; i < pixels; ++i) {
            for (int c = 0; c < 3; ++c) rgb[3 * (first + i) + c] = nearest_byte(display[c][i]);
        }
    }
}

Image develop(const Image& radiance, const FilmSettings& settings, FilmReport* report) {
    Image display{radiance.width, radiance.height, radiance.channels, {}};
    display.values.resize(radiance.values.size());
    if (report) {
        for (const float value : radiance.values) count(value, *report);
    }
    constexpr std::size_t kPiece = 4096;
    for (std::size_t first = 0; first < radiance.values.size(); first += kPiece) {
        const auto lanes = static_cast<int>(std::min(radiance.values.size() - first, kPiece));
        develop_values(radiance.values.data() + first, lanes, settings, display.values.data() + first);
    }
    return display;
}

Image without_non_finite(const Image& radiance, FilmReport* report) {
    Image clean = radiance;
    for (float& value : clean.values) {
        if (report) count(value, *report);
        if (std::isnan(value)) value = 0.0f;
        if (std::isinf(value)) value = value > 0.0f ? kMaxFinite : -kMaxFinite;
    }
    return clean;
}

}  // namespace kreda::raster
