#include "raster/film.hpp"

#include <cmath>

namespace kreda::raster {

namespace {

/// NaN becomes 0.
float exposed(float radiance, const FilmSettings& settings) {
    const float scaled = radiance * settings.exposure;
    return scaled > 0.0f ? scaled : 0.0f;
}

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
    return saturate(encode(saturate(tone_map(exposed(radiance, settings), settings)), settings));
}

/// display_value() of each, step by step: the loops hold no choice, so each becomes one over many lanes.
Image develop(const Image& radiance, const FilmSettings& settings, FilmReport* report) {
    Image display = radiance;
    const auto each = [&](auto step) {
        for (float& value : display.values) value = step(value);
    };
    if (report) {
        for (const float value : radiance.values) count(value, *report);
    }
    each([&](float x) { return exposed(x, settings); });
    switch (settings.tone_map) {
        case ToneMap::none: break;
        case ToneMap::reinhard: each([](float x) { return reinhard(x); }); break;
        case ToneMap::reinhard_extended: each([&](float x) { return reinhard_extended(x, settings.white); }); break;
    }
    each([](float x) { return saturate(x); });
    switch (settings.transfer) {
        case Transfer::srgb: each([](float x) { return srgb_from_linear(x); }); break;
        case Transfer::gamma: each([&](float x) { return pow(x, 1.0f / settings.gamma); }); break;
        case Transfer::linear: break;
    }
    each([](float x) { return saturate(x); });
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
