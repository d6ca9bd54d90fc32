// From radiance straight to the 8 bits a channel that a display is sent, where nothing keeps the radiance.
#pragma once

#include <cstdint>
#include <vector>

#include "raster/film.hpp"

namespace kreda::raster {

/// 8 bits a channel, the channels of a pixel side by side, rows from the top.
struct ByteImage {
    int width = 0;                     ///< pixels
    int height = 0;                    ///< pixels
    int channels = 0;                  ///< 1, or 3 for red, green, blue
    std::vector<std::uint8_t> values;  ///< as the file encodes them, 0..255
};

/// What pixels hold that are shown: values that no display can show, and whether any of them is not black.
struct ShownValues {
    FilmReport report;       ///< values that had to be clamped
    bool any_light = false;  ///< a value is not 0
};

/// `more` added to `shown`.
void add(const ShownValues& more, ShownValues& shown);

/// A row of pixels as a display is sent it, red, green and blue side by side: display_value(radiance) in 255ths, the
/// nearest, half up. What is odd is added to `shown`. The arrays do not overlap.
void show_row(const float* const radiance[3], int count, const FilmSettings& settings, std::uint8_t* rgb,
              ShownValues& shown);

}  // namespace kreda::raster
