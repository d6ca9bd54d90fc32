#include "raster/film.hpp"

#include <cmath>

namespace kreda::raster {

namespace {

float tone_map(float radiance, const FilmSettings& settings) {
    switch (settings.tone_map) {
        case ToneMap::none: return radiance;
        case ToneMap::reinhard: return reinhard(radiance);
        case ToneMap::reinhard_extended: return reinhard_extended(radiance, settings.white);
    }
    return radiance;
}

float encode(float linear, const FilmSettings& settings) {
    switch (settings.transfer) {
        case Transfer::srgb: return srgb_from_linear(linear);
        case Transfer::gamma: return pow(linear, 1.0f / settings.gamma);
        case Transfer::linear: return linear;
    }
    return linear;
}

void count(float value, FilmReport& report) {
    report.not_a_number += std::isnan(value) ? 1 : 0;
    report.infinite += std::isinf(value) ? 1 : 0;
    report.negative += value < 0.0f && std::isfinite(value) ? 1 : 0;
}

}  // namespace

float display_value(float radiance, const FilmSettings& settings) {
    const float exposed = radiance * settings.exposure;
    const float positive = exposed > 0.0f ? exposed : 0.0f;  // NaN becomes 0 here
    return saturate(encode(saturate(tone_map(positive, settings)), settings));
}

Image develop(const Image& radiance, const FilmSettings& settings, FilmReport* report) {
    Image display = radiance;
    for (float& value : display.values) {
        if (report) count(value, *report);
        value = display_value(value, settings);
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
