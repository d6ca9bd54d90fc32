// What a comparison looks like: pictures for people; the numbers decide.
#pragma once

#include "raster/image.hpp"
#include "tools/compare/compare.hpp"

namespace kreda::tools {

/// A picture to look at, 3 channels encoded for a PNG: the first three channels of integers as they are stored;
/// floating-point numbers as linear light in sRGB. NaN is shown red.
[[nodiscard]] raster::Image shown(const raster::Image& image, Numbers numbers);

/// The colour of a difference: the dim grey of `expected` where there is none, blue for a step, through yellow to red
/// for 16 steps and more. Same size as `expected`; needs comparison.comparable.
[[nodiscard]] raster::Image heat_map(const Comparison& comparison, const raster::Image& expected, Numbers numbers);

/// Both pictures and, where they are comparable, the heat map, one beside the other with their captions. Small ones are
/// enlarged.
[[nodiscard]] raster::Image side_by_side(const Comparison& comparison, const raster::Image& actual,
                                         const raster::Image& expected, Numbers numbers);

}  // namespace kreda::tools
