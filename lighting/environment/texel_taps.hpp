// Reading maps for a batch of points, in two steps: one loop finds which texels each point needs and their weights
// (arithmetic, a vector register of points at a time), a second one fetches them (memory: a texel's four floats are a
// vector register of their own, which is faster than gathering one float for each of 16 points).
#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>

#include "raster/fragments.hpp"

namespace kreda::lighting {

/// Four neighbouring texels of four floats each, and their weights.
struct TexelTap {
    std::int32_t first;            ///< index of the upper left texel's first float; the upper right one follows
    std::int32_t next_row;         ///< floats from a row to the next
    float w_00, w_10, w_01, w_11;  ///< weights: upper left, upper right, lower left, lower right
};

/// Bilinear weights for a point that lies fx of a texel to the right of the upper left centre and fy below it, times
/// `share`.
inline TexelTap bilinear_tap(int first, int next_row, float fx, float fy, float share) {
    const float upper = (1.0f - fy) * share;
    const float lower = fy * share;
    return {first, next_row, (1.0f - fx) * upper, fx * upper, (1.0f - fx) * lower, fx * lower};
}

/// The first three floats of   sum of w texel.
inline glm::vec3 weighted_sum(const float* texels, const TexelTap& tap) {
    const float* a = texels + tap.first;
    const float* b = a + tap.next_row;
    glm::vec3 sum;
    for (int c = 0; c < 3; ++c) {
        sum[c] = (tap.w_00 * a[c] + tap.w_10 * a[c + 4]) + (tap.w_01 * b[c] + tap.w_11 * b[c + 4]);
    }
    return sum;
}

/// The taps of a batch.
struct TapChannels {
    alignas(64) std::int32_t first[raster::kChannelSize];     ///< see TexelTap
    alignas(64) std::int32_t next_row[raster::kChannelSize];  ///< see TexelTap
    raster::Channel w_00, w_10, w_01, w_11;                   ///< see TexelTap; they sum to 1

    /// Puts a tap at place i.
    void set(int i, const TexelTap& tap) {
        first[i] = tap.first;
        next_row[i] = tap.next_row;
        w_00.set(i, tap.w_00);
        w_10.set(i, tap.w_10);
        w_01.set(i, tap.w_01);
        w_11.set(i, tap.w_11);
    }
};

/// What one look-up of a batch needs besides its input and its result.
struct TapScratch {
    TapChannels taps[2];                                ///< the second one for the second level of a trilinear look-up
    alignas(64) float texel[4 * raster::kChannelSize];  ///< weighted sums, four floats a point
};

/// scratch.texel = sum of w texel over scratch.taps[0], and over taps[1] too with `levels` = 2.
void read_taps(const float* texels, int lanes, int levels, TapScratch& scratch);

/// Four floats a point become three channels.
void split_texels(int lanes, const TapScratch& scratch, raster::Channel3& colors);

}  // namespace kreda::lighting
