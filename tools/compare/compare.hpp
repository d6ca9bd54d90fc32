// Comparing two pictures as a grader must: hard gates first, then counts in tiers, each beside its limit.
//
// Differences are counted in steps. For pictures of integers a step is one code: 1/255 of the range for 8 bits. For
// floating-point numbers it is 1/255 of the expected value, at least 1/255 of kSmallestFloatWhite, so that a step is
// about as visible in the light as in the dark. A pixel differs by the most that any of its channels differs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "raster/image.hpp"
#include "tools/compare/measurement.hpp"

namespace kreda::tools {

inline constexpr float kSmallestFloatWhite = 1.0f / 16.0f;
/// Floating-point numbers that are nearer than this, in steps, count as equal: rounding is no difference.
inline constexpr float kFloatNoise = 1.0f / 64.0f;

/// How much may differ. The defaults let other compilers, optimisations and orders of additions pass (at most 8 of
/// 307 200 pixels by one step were measured) and stop every classic mistake that changes the picture.
struct CompareLimits {
    double differing_percent = 0.5;  ///< of the pixels may differ at all
    int more_than_a_step = 16;       ///< pixels may differ by more than one step; never more than may differ at all
    int blob = 4;  ///< of those may touch each other, also at a corner: a triangle is missing beyond that
};

/// Nothing may differ.
inline constexpr CompareLimits kExact{0.0, 0, 0};

/// What the numbers of both pictures are.
struct Numbers {
    int levels = 256;  ///< how many values a channel can have, or 0 for floating-point numbers
};

/// One pixel with the values of both pictures, a channel each: codes for integers, else the numbers.
struct PixelPair {
    int x = 0, y = 0;
    double steps = 0.0;
    std::vector<double> actual, expected;
};

struct Comparison {
    bool passed = false;
    bool identical = false;   ///< every number of both is the same and finite
    bool comparable = false;  ///< same size and channels, all finite: without it there are no counts
    std::vector<Measurement> checks;
    std::size_t differing = 0;
    PixelPair worst;           ///< where they differ most, the first of them from the top; needs differing > 0
    std::vector<float> steps;  ///< by how much each pixel differs, row by row from the top; empty if not comparable
};

/// `mask` (optional, same width and height, channel 0) marks with values above 0.5 the pixels where rounding may
/// decide, an edge or a tie of depths: where there is one, a pixel outside of it may not differ by more than a step.
[[nodiscard]] Comparison compare(const raster::Image& actual, const raster::Image& expected, Numbers numbers = {},
                                 const CompareLimits& limits = {}, const raster::Image* mask = nullptr);

/// "0 of 57600 pixels differ: identical" or "12 of 57600 pixels differ, most at (3, 4): (1, 2, 3), expected (1, 2, 9),
/// 6 steps"; where they are not comparable, why.
[[nodiscard]] std::string describe(const Comparison& comparison);

/// "(12, 40, 200)"
[[nodiscard]] std::string values_text(const std::vector<double>& values);

}  // namespace kreda::tools
