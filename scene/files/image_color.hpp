// What the numbers of an image file are as colours: which channels, and how light was encoded in them.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "raster/film.hpp"
#include "scene/files/image_file.hpp"

namespace kreda::scene {

/// The channels that are the colour of an image.
struct ColorChannels {
    int count = 3;                         ///< 1: grey, index[0]; 3: red, green, blue
    std::array<int, 3> index = {0, 1, 2};  ///< -1: the file has none
    std::string found;                     ///< for people, where it is not plain: "has the channel Z alone"
    std::string made;                      ///< and what is made of it: "it is taken as grey"
};

/// By name: R, G, B wherever they stand, else Y or the first channel as grey. `alpha`: a channel that is no colour, or
/// -1. Red and green alone are a colour without blue.
[[nodiscard]] ColorChannels color_channels(const std::vector<std::string>& names, int alpha);

/// Linear light from a stored value. sRGB: IEC 61966-2-1; power: v^gamma.
[[nodiscard]] inline float linear_from_stored(float stored, const StoredImage& image) {
    if (image.encoding == Encoding::linear) return stored;
    if (image.encoding == Encoding::srgb) return raster::linear_from_srgb(stored);
    return std::pow(raster::saturate(stored), image.gamma);
}

/// Something to say where an image is not encoded as its kind usually is; else "".
[[nodiscard]] std::string encoding_remark(const StoredImage& image);

/// Decode the values of a plane. Integers have few values: each is decoded once.
template <class Decode>
void decode_plane(const float* stored, std::size_t count, int levels, Decode decode, float* decoded) {
    if (levels == 0) {
        for (std::size_t i = 0; i < count; ++i) decoded[i] = decode(stored[i]);
        return;
    }
    const float greatest = static_cast<float>(levels - 1);
    std::vector<float> table(static_cast<std::size_t>(levels));
    for (std::size_t v = 0; v < table.size(); ++v) table[v] = decode(static_cast<float>(v) / greatest);
    for (std::size_t i = 0; i < count; ++i) {
        decoded[i] = table[static_cast<std::size_t>(raster::saturate(stored[i]) * greatest + 0.5f)];
    }
}

/// The colours of an image as linear light: 1 channel (grey) or 3. NaN and infinity stay.
[[nodiscard]] raster::Image linear_colors(StoredImage stored, const ColorChannels& channels);

/// Divide the colours by alpha where they were multiplied by it; where alpha is 0 they stay.
void divide_by_alpha(raster::Image& image, const ColorChannels& channels, int alpha);

}  // namespace kreda::scene
