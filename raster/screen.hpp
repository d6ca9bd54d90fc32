// From clip space to the pixel grid: the perspective divide, the snap to 1/256 pixel, exact edge functions.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <type_traits>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "raster/scalar_math.hpp"

namespace kreda::raster {

/// Positions on the screen are integers in units of 1/256 pixel: then "is the point left of this edge?" has an
/// exact answer, closed surfaces have no cracks, and no pixel is drawn twice along a shared edge.
inline constexpr int kSubpixelBits = 8;
/// Steps a pixel: corners are rounded to 1/256.
inline constexpr int kSubpixels = 1 << kSubpixelBits;
/// The centre of a pixel, in those steps.
inline constexpr int kPixelCentre = kSubpixels / 2;
/// Centre of the sample with that column or row, in those steps.
inline constexpr std::int32_t centre_of(int sample) {
    return sample * kSubpixels + kPixelCentre;
}

/// Largest image, in samples a side.
inline constexpr int kMaxImageSide = 16384;

/// Triangles are clipped only where they leave this many samples around the image's centre (the guard band): what
/// sticks out less is cut off by the bounding box for free. 2^14 keeps every edge step below 2^23, see
/// rasterize_tile.cpp.
inline constexpr float kGuardBand = 16384.0f - 1.0f;

/// Size of the sample grid: pixels, or n x n times as many with supersampling. Row 0 is the top row.
struct Viewport {
    int width = 0;   ///< samples
    int height = 0;  ///< samples
};

/// A vertex after the perspective divide. x to the right, y DOWN, both in 1/256 sample; the centre of the first
/// sample is (128, 128). z in [0, 1], 0 at the near plane. inv_w = 1/w > 0.
struct ScreenVertex {
    std::int32_t x = 0;  ///< 1/256 sample, from the left
    std::int32_t y = 0;  ///< 1/256 sample, from the top
    float z = 0.0f;      ///< window depth
    float inv_w = 0.0f;  ///< what attributes are divided by: linear on the screen
};

/// x of a vertex that has no place on the screen: its triangles go through the clipper.
inline constexpr std::int32_t kNeedsClip = INT32_MIN;

/// Is a clip-space position inside the near and far planes and the guard band? False for NaN, and where 1/w is not
/// finite and above zero.
inline bool inside_guard_band(const glm::vec4& clip, float guard_x, float guard_y) {
    const bool can_divide = (clip.w >= kMinNormal) & (clip.w <= kMaxFinite);
    const bool in_depth = (clip.z >= -clip.w) & (clip.z <= clip.w);
    const bool in_x = (clip.x >= -guard_x * clip.w) & (clip.x <= guard_x * clip.w);
    const bool in_y = (clip.y >= -guard_y * clip.w) & (clip.y <= guard_y * clip.w);
    return can_divide & in_depth & in_x & in_y;
}

/// How far the guard band reaches in normalized device coordinates: up to kGuardBand samples from the centre of an
/// image of this many samples. Rounded down to a power of two: then guard * w is exact, and the vertex stage and the
/// clipper never disagree about a vertex on the border.
inline float guard_band_ndc(int image_side) {
    constexpr std::uint32_t kSignAndExponent = 0xff800000u;
    const float reach = kGuardBand / (0.5f * static_cast<float>(image_side));
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(reach) & kSignAndExponent);
}

/// Window coordinate -> 1/256 sample, nearest, halves up. What lies beyond 2^15 samples, or is NaN, comes out as some
/// number: no such vertex is drawn, but the loop over all vertices passes here with each of them.
inline std::int32_t snap(float window) {
    constexpr float kLimit = 32768.0f * kSubpixels;
    const float subpixels = window * kSubpixels;
    const float not_below = subpixels > -kLimit ? subpixels : -kLimit;
    return round_half_up_to_int(not_below < kLimit ? not_below : kLimit);
}

/// Normalized device coordinates (x/w, y/w, z/w) -> window: x and y in samples, y down; z in [0, 1].
///   x_window = (x/w + 1) width/2     y_window = (1 - y/w) height/2     z_window = (z/w + 1)/2
inline glm::vec3 window_from_ndc(const glm::vec3& ndc, const Viewport& viewport) {
    const float half_width = 0.5f * static_cast<float>(viewport.width);
    const float half_height = 0.5f * static_cast<float>(viewport.height);
    const float x_window = ndc.x * half_width + half_width;
    const float y_window = half_height - ndc.y * half_height;
    const float z_window = ndc.z * 0.5f + 0.5f;
    return {x_window, y_window, z_window};
}

/// Perspective divide, viewport and snap: clip -> screen. Means something only inside_guard_band().
inline ScreenVertex to_screen(const glm::vec4& clip, const Viewport& viewport) {
    const float inv_w = 1.0f / clip.w;
    const glm::vec3 ndc{clip.x * inv_w, clip.y * inv_w, clip.z * inv_w};
    const glm::vec3 window = window_from_ndc(ndc, viewport);
    return {snap(window.x), snap(window.y), window.z, inv_w};
}

/// Twice the signed area of the triangle a, b, p:  E = (b_x - a_x)(p_y - a_y) - (b_y - a_y)(p_x - a_x).
/// Exact. With y down, E > 0 means: going from a to b, p lies to the right.                  Pineda 1988
/// `Exact` is int64, or in batch loops double, which fills vector registers: inside the guard band |E| < 2^48, and a
/// double holds every integer up to 2^53.
template <class Exact = std::int64_t>
inline Exact edge_function(std::type_identity_t<Exact> a_x, std::type_identity_t<Exact> a_y,
                           std::type_identity_t<Exact> b_x, std::type_identity_t<Exact> b_y,
                           std::type_identity_t<Exact> p_x, std::type_identity_t<Exact> p_y) {
    return (b_x - a_x) * (p_y - a_y) - (b_y - a_y) * (p_x - a_x);
}

/// A pixel centre exactly on an edge belongs to the triangle only if the edge is a top edge (horizontal, the
/// triangle below it) or a left edge. Edge direction b - a, triangle to the right of it, y down.
/// Without a branch, in the width of the caller's integers: batch loops ask it of many edges at once.
template <class Integer>
inline bool is_top_left(Integer d_x, Integer d_y) {
    return (d_y < 0) | ((d_y == 0) & (d_x > 0));
}

/// The least E at which a sample counts as inside of an edge: 0 for a top or left edge, 1 for the others.
template <class Integer>
inline Integer least_inside(Integer d_x, Integer d_y) {
    return Integer{1} - static_cast<Integer>(is_top_left(d_x, d_y));
}

/// Does the triangle a, b, c (clockwise, y down) cover the centre of sample (x, y)?
/// A centre exactly on an edge (E = 0) is inside only for top and left edges: the others ask for E > 0.
inline bool covers_sample(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c, int x, int y) {
    const std::int64_t p_x = centre_of(x);
    const std::int64_t p_y = centre_of(y);
    const std::int64_t least_ab = least_inside(b.x - a.x, b.y - a.y);
    const std::int64_t least_bc = least_inside(c.x - b.x, c.y - b.y);
    const std::int64_t least_ca = least_inside(a.x - c.x, a.y - c.y);
    const bool inside_ab = edge_function(a.x, a.y, b.x, b.y, p_x, p_y) >= least_ab;
    const bool inside_bc = edge_function(b.x, b.y, c.x, c.y, p_x, p_y) >= least_bc;
    const bool inside_ca = edge_function(c.x, c.y, a.x, a.y, p_x, p_y) >= least_ca;
    return inside_ab & inside_bc & inside_ca;
}

/// Samples from x_first to x_last and y_first to y_last; none if a first is greater than its last.
struct SampleBox {
    int x_first = 0, y_first = 0, x_last = -1, y_last = -1;  ///< both included
};

/// The samples of the image that a triangle may cover.
inline SampleBox sample_box(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c, int width,
                            int height) {
    SampleBox box;
    box.x_first = std::max(std::min({a.x, b.x, c.x}) >> kSubpixelBits, 0);
    box.y_first = std::max(std::min({a.y, b.y, c.y}) >> kSubpixelBits, 0);
    box.x_last = std::min(std::max({a.x, b.x, c.x}) >> kSubpixelBits, width - 1);
    box.y_last = std::min(std::max({a.y, b.y, c.y}) >> kSubpixelBits, height - 1);
    return box;
}

}  // namespace kreda::raster
