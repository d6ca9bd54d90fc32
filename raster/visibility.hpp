// The visibility buffer: for every sample the nearest triangle and its depth.             Burns & Hunt 2013
#pragma once

#include <cstdint>
#include <vector>

namespace kreda::raster {

/// Number of "no triangle here".
inline constexpr std::uint32_t kNoTriangle = 0xffffffffu;

/// Depth of a sample that nothing covers: the far plane.
inline constexpr float kClearDepth = 1.0f;

/// What is nearest at each sample: depth and number of the triangle.
struct VisibilityBuffer {
    int width = 0;                        ///< samples
    int height = 0;                       ///< samples
    std::vector<float> depth;             ///< window depth in [0, 1], row 0 on top
    std::vector<std::uint32_t> triangle;  ///< triangle_id(), or kNoTriangle

    VisibilityBuffer() = default;
    /// Nothing seen yet, w x h samples.
    VisibilityBuffer(int w, int h)
        : width(w),
          height(h),
          depth(static_cast<std::size_t>(w) * h, kClearDepth),
          triangle(static_cast<std::size_t>(w) * h, kNoTriangle) {}
};

}  // namespace kreda::raster
