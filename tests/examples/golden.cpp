#include "golden.hpp"

#include <algorithm>
#include <cmath>

namespace kreda::tests {

raster::Image amplified_difference(const raster::Image& actual, const raster::Image& expected) {
    raster::Image difference = actual;
    for (std::size_t i = 0; i < difference.values.size(); ++i) {
        difference.values[i] = std::min(16.0f * std::abs(actual.values[i] - expected.values[i]), 1.0f);
    }
    return difference;
}

}  // namespace kreda::tests
