// Comparing pictures byte by byte, by tools/compare with all limits 0.
#pragma once

#include "raster/image.hpp"
#include "tools/compare/compare.hpp"

namespace kreda::tests {

[[nodiscard]] inline tools::Comparison compare_bytes(const raster::Image& actual, const raster::Image& expected) {
    return tools::compare(actual, expected, {}, tools::kExact);
}

/// |actual - expected|, 16 times as bright, so that one step of 255 can be seen. Needs the same size.
[[nodiscard]] raster::Image amplified_difference(const raster::Image& actual, const raster::Image& expected);

}  // namespace kreda::tests
