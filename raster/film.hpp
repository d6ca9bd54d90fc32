// From linear radiance to what a display shows: exposure, tone mapping, transfer function.
#pragma once

#include <cstdint>

#include "raster/image.hpp"
#include "raster/scalar_math.hpp"

namespace kreda::raster {

/// How radiance comes to 0..1 (docs/70_hdr_tone_mapping.md).
enum class ToneMap { none, reinhard, reinhard_extended };
/// How linear values are encoded for 8 bits (docs/71_gamma.md).
enum class Transfer { srgb, gamma, linear };

/// From linear radiance to what a file holds.
struct FilmSettings {
    float exposure = 1.0f;               ///< multiplies radiance first
    ToneMap tone_map = ToneMap::none;    ///< none: clamp to 1
    float white = 4.0f;                  ///< reinhard_extended: the radiance that maps to 1
    Transfer transfer = Transfer::srgb;  ///< from linear to what a display takes
    float gamma = 2.2f;                  ///< transfer = gamma: encoded = linear^(1/gamma)
};

/// Values that no display can show, and how often they came up.
struct FilmReport {
    std::uint64_t not_a_number = 0;  ///< shown as 0
    std::uint64_t infinite = 0;      ///< +inf shown as the brightest value, -inf as 0
    std::uint64_t negative = 0;      ///< shown as 0
};

/// Reinhard's operator   L / (1 + L),  per channel, L >= 0; infinity gives 1.    Reinhard et al. 2002, eq. 3
inline float reinhard(float radiance) {
    const float large = 1.0f - 1.0f / (1.0f + radiance);
    const float small = radiance / (1.0f + radiance);
    return radiance > 1.0f ? large : small;
}

/// Extended operator   L (1 + L/white^2) / (1 + L);  L = white gives 1.    Reinhard et al. 2002, eq. 4
inline float reinhard_extended(float radiance, float white) {
    const float safe = radiance < 1e18f ? radiance : 1e18f;
    return reinhard(safe) * (1.0f + safe / (white * white));
}

/// sRGB's encoding of [0, 1]   12.92 x below 0.0031308,  1.055 x^(1/2.4) - 0.055 above.    IEC 61966-2-1:1999
inline float srgb_from_linear(float x) {
    const float toe = 12.92f * x;
    const float shoulder = 1.055f * pow(x > 0.0f ? x : 0.0f, 1.0f / 2.4f) - 0.055f;
    return x <= 0.0031308f ? toe : shoulder;
}

/// sRGB's decoding of [0, 1], the inverse of the above.    IEC 61966-2-1:1999
inline float linear_from_srgb(float x) {
    const float toe = x / 12.92f;
    const float shoulder = pow((x + 0.055f) / 1.055f > 0.0f ? (x + 0.055f) / 1.055f : 0.0f, 2.4f);
    return x <= 0.04045f ? toe : shoulder;
}

/// One radiance value on its way to the display: exposure, tone map, clamp to 0..1, transfer function.
[[nodiscard]] float display_value(float radiance, const FilmSettings& settings);

/// The whole film, ready to be quantised: every value finite and in 0..1.
[[nodiscard]] Image develop(const Image& radiance, const FilmSettings& settings, FilmReport* report = nullptr);

/// Replace what a file must not hold: NaN by 0, infinities by the largest finite value of their sign.
[[nodiscard]] Image without_non_finite(const Image& radiance, FilmReport* report = nullptr);

}  // namespace kreda::raster
