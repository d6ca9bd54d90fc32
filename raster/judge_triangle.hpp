// Which triangles are worth drawing: facing the right way, and covering a sample.
#pragma once

#include <algorithm>
#include <cstdint>

#include "raster/cull_mode.hpp"
#include "raster/sample_edges.hpp"
#include "raster/screen.hpp"

namespace kreda::raster {

/// What becomes of a triangle.
enum class Fate : std::int32_t { drawn, degenerate, culled, outside, needs_clip };

/// First and last sample whose centre lies in [min, max] (1/256 sample); none if first > last.
struct SampleRange {
    std::int32_t first, last;  ///< both included
};

/// The range of samples whose centres lie in [min, max].
inline SampleRange samples_between(std::int32_t min, std::int32_t max) {
    const auto below_max = static_cast<std::uint32_t>(max) - kPixelCentre;  // kNeedsClip wraps around
    return {(min + kPixelCentre - 1) >> kSubpixelBits, static_cast<std::int32_t>(below_max) >> kSubpixelBits};
}

/// The samples of a range that an image of `side` samples has.
inline SampleRange inside_image(const SampleRange& range, int side) {
    return {std::max(range.first, 0), std::min(range.last, side - 1)};
}

/// A corner on the screen, 1/256 sample; depth does not matter here.
struct ScreenPoint {
    std::int32_t x, y;  ///< to the right, and down
};

/// The place of a vertex without its depth.
inline ScreenPoint point_of(const ScreenVertex& v) {
    return {v.x, v.y};
}

/// What becomes of a triangle; if it is drawn, the samples that it may cover.
struct Judgement {
    Fate fate;         ///< drawn, or why not
    bool front;        ///< counter-clockwise with y up: the second and third corner must change places
    SampleRange x, y;  ///< columns and rows of the box
};

/// Judge a triangle by where it faces (the sign of the snapped area says it) and by its box.
inline Judgement judge(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c, CullMode cull,
                       const Viewport& viewport) {
    const float area = static_cast<float>(edge_function<double>(a.x, a.y, b.x, b.y, c.x, c.y));  // keeps the sign
    const bool front = area < 0.0f;  // counter-clockwise with y up is negative with y down
    const SampleRange x = inside_image(
        samples_between(std::min(std::min(a.x, b.x), c.x), std::max(std::max(a.x, b.x), c.x)), viewport.width);
    const SampleRange y = inside_image(
        samples_between(std::min(std::min(a.y, b.y), c.y), std::max(std::max(a.y, b.y), c.y)), viewport.height);
    const bool no_centre = (x.first > x.last) | (y.first > y.last);
    const bool wrong_way = (front & (cull == CullMode::front)) | (!front & (cull == CullMode::back));
    const bool needs_clip = (a.x == kNeedsClip) | (b.x == kNeedsClip) | (c.x == kNeedsClip);
    const Fate in_view = no_centre ? Fate::outside : Fate::drawn;
    const Fate facing = wrong_way ? Fate::culled : in_view;
    const Fate with_area = area == 0.0f ? Fate::degenerate : facing;
    return {needs_clip ? Fate::needs_clip : with_area, front, x, y};
}

/// The edge from a to b at the sample centre (0, 0). Corners at most 5 samples away: 32 bits hold every product.
inline SampleEdge near_edge(const ScreenPoint& a, const ScreenPoint& b) {
    const std::int32_t d_x = b.x - a.x, d_y = b.y - a.y;
    return {(d_y * a.x - d_x * a.y - least_inside(d_x, d_y)) >> kSubpixelBits, -d_y, d_x};
}

/// Does the clockwise triangle a, b, c cover a sample of the block that begins with the sample centre (0, 0)?
inline bool covers_block(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
    return covered_in_block({near_edge(a, b), near_edge(b, c), near_edge(c, a)}, 0, 0) != 0;
}

/// Is a triangle with a centre in its box so small that the box fits into a block?
inline bool fits_block(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
    const SampleRange x = samples_between(std::min(std::min(a.x, b.x), c.x), std::max(std::max(a.x, b.x), c.x));
    const SampleRange y = samples_between(std::min(std::min(a.y, b.y), c.y), std::max(std::max(a.y, b.y), c.y));
    return (x.last - x.first < kBlockSide) & (y.last - y.first < kBlockSide);
}

/// Look closer at a triangle that judge() would draw: if it is small and misses every sample of its box, it is outside.
inline Fate look_closer(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c, const Judgement& judgement) {
    const bool small = (judgement.fate == Fate::drawn) & fits_block(a, b, c);
    const std::int32_t keep = -static_cast<std::int32_t>(small);  // a mask: with ?: GCC makes it a branch
    const std::int32_t p_x = centre_of(judgement.x.first) & keep;
    const std::int32_t p_y = centre_of(judgement.y.first) & keep;
    const auto near = [&](std::int32_t x, std::int32_t y) { return ScreenPoint{(x & keep) - p_x, (y & keep) - p_y}; };
    const bool front = judgement.front;
    const bool covers = covers_block(near(a.x, a.y), near(front ? c.x : b.x, front ? c.y : b.y),
                                     near(front ? b.x : c.x, front ? b.y : c.y));
    return (small & !covers) ? Fate::outside : judgement.fate;
}

}  // namespace kreda::raster
