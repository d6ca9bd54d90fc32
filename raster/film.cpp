#include "raster/film.hpp"

#include <cmath>

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

void count(float value, FilmReport& report) {
    report.not_a_number += std::isnan(value) ? 1 : 0;
    report.infinite += std::isinf(value) ? 1 : 0;
    report.negative += value < 0.0f && std::isfinite(value) ? 1 : 0;
}

}  // namespace

float display_value(float radiance, const FilmSettings& settings) {
    return with_film_formulas(
        settings, [&](auto tone_map, auto encode) { return developed(radiance, settings.exposure, tone_map, encode); });
}

Image develop(const Image& radiance, const FilmSettings& settings, FilmReport* report) {
    Image display = radiance;
    if (report) {
        for (const float value : radiance.values) count(value, *report);
    }
    // What is chosen is asked once, not at each value: the loop becomes one over many lanes.
    with_film_formulas(settings, [&, exposure = settings.exposure](auto tone_map, auto encode) {
        for (float& value : display.values) value = developed(value, exposure, tone_map, encode);
    });
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
