// Comparing pictures byte by byte: what differs, by how much at most, and where first.
#pragma once

#include <string>

#include "raster/image.hpp"

namespace kreda::tests {

struct ImageDifference {
    bool same_size = false;        ///< width, height and channels; without it nothing else is known
    int pixels = 0;                ///< that differ in any channel
    int largest = 0;               ///< largest difference of a channel, 0..255
    int first_x = 0, first_y = 0;  ///< the first pixel that differs, row by row from the top
    [[nodiscard]] bool none() const {
        return same_size && pixels == 0;
    }
};

/// The byte that a PNG holds for a value of 0..1.
[[nodiscard]] int byte_of(float value);

[[nodiscard]] ImageDifference compare_bytes(const raster::Image& actual, const raster::Image& expected);

/// |actual - expected|, 16 times as bright, so that one step of 255 can be seen. Needs the same size.
[[nodiscard]] raster::Image amplified_difference(const raster::Image& actual, const raster::Image& expected);

/// A sentence for the log.
[[nodiscard]] std::string describe(const ImageDifference& difference);

}  // namespace kreda::tests
