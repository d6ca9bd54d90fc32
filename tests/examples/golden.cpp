#include "golden.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace kreda::tests {

int byte_of(float value) {
    return static_cast<int>(std::lround(255.0f * value));
}

ImageDifference compare_bytes(const raster::Image& actual, const raster::Image& expected) {
    ImageDifference difference;
    difference.same_size =
        actual.width == expected.width && actual.height == expected.height && actual.channels == expected.channels;
    if (!difference.same_size) return difference;
    for (int y = 0; y < actual.height; ++y) {
        for (int x = 0; x < actual.width; ++x) {
            int largest = 0;
            for (int c = 0; c < actual.channels; ++c) {
                largest = std::max(largest, std::abs(byte_of(actual.at(c, x, y)) - byte_of(expected.at(c, x, y))));
            }
            if (largest == 0) continue;
            if (difference.pixels == 0) {
                difference.first_x = x;
                difference.first_y = y;
            }
            ++difference.pixels;
            difference.largest = std::max(difference.largest, largest);
        }
    }
    return difference;
}

raster::Image amplified_difference(const raster::Image& actual, const raster::Image& expected) {
    raster::Image difference = actual;
    for (std::size_t i = 0; i < difference.values.size(); ++i) {
        difference.values[i] = std::min(16.0f * std::abs(actual.values[i] - expected.values[i]), 1.0f);
    }
    return difference;
}

std::string describe(const ImageDifference& difference) {
    if (!difference.same_size) return "another size or number of channels";
    if (difference.none()) return "identical";
    return std::to_string(difference.pixels) + " pixels differ, by at most " + std::to_string(difference.largest) +
           " of 255 (limit 0), the first at x = " + std::to_string(difference.first_x) +
           ", y = " + std::to_string(difference.first_y);
}

}  // namespace kreda::tests
