// Depth across a triangle: z/w is affine on the screen, so two slopes say everything.
#pragma once

#include <algorithm>
#include <cstdint>

#include "raster/screen.hpp"

namespace kreda::raster {

/// The plane of window depth over a triangle, anchored at its first vertex so that nothing drifts along a row.
struct DepthPlane {
    std::int32_t x0 = 0, y0 = 0;       ///< the anchor, 1/256 sample
    float z0 = 0.0f;                   ///< depth at the anchor
    float dz_dx = 0.0f, dz_dy = 0.0f;  ///< change per sample to the right, and down
    float z_min = 0.0f, z_max = 0.0f;  ///< of the three vertices: slivers must not shoot out of their own range
};

/// Depth plane of a triangle with positive area2 = edge_function(a, b, c), an integer below 2^48. Slopes in double,
/// rounded once.
inline DepthPlane depth_plane(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c, double area2) {
    const double ab_x = b.x - a.x, ab_y = b.y - a.y, ab_z = double{b.z} - double{a.z};
    const double ac_x = c.x - a.x, ac_y = c.y - a.y, ac_z = double{c.z} - double{a.z};
    const double scale = kSubpixels / area2;
    DepthPlane plane;
    plane.x0 = a.x;
    plane.y0 = a.y;
    plane.z0 = a.z;
    plane.dz_dx = static_cast<float>((ab_z * ac_y - ac_z * ab_y) * scale);
    plane.dz_dy = static_cast<float>((ac_z * ab_x - ab_z * ac_x) * scale);
    plane.z_min = std::min(std::min(a.z, b.z), c.z);
    plane.z_max = std::max(std::max(a.z, b.z), c.z);
    return plane;
}

/// How many samples the centre of row y lies below the anchor. In a row that the triangle reaches it is exact, and so
/// is one more for each row further down: corners are less than 2^23 apart (kGuardBand), a float holds 24 bits.
inline float rows_below_anchor(const DepthPlane& plane, std::int32_t y) {
    return static_cast<float>(centre_of(y) - plane.y0) * (1.0f / kSubpixels);
}

/// The part of the depth that one row of samples shares: z0 + dz/dy (y - y0).
inline float depth_below_anchor(const DepthPlane& plane, float rows_below) {
    return plane.z0 + plane.dz_dy * rows_below;
}

/// The same at the centre of row y.
inline float depth_of_row(const DepthPlane& plane, std::int32_t y) {
    return depth_below_anchor(plane, rows_below_anchor(plane, y));
}

/// The part that one column shares: dz/dx (x - x0), at the centre of column x.
inline float depth_of_column(const DepthPlane& plane, std::int32_t x) {
    const float d_x = static_cast<float>(centre_of(x) - plane.x0) * (1.0f / kSubpixels);
    return plane.dz_dx * d_x;
}

/// Depth at the centre of a sample from what its row and its column share.
inline float depth_from(const DepthPlane& plane, float row_depth, float column_depth) {
    const float z = row_depth + column_depth;
    const float not_nearer = z < plane.z_min ? plane.z_min : z;
    return not_nearer > plane.z_max ? plane.z_max : not_nearer;
}

/// Depth at the centre of sample x of a row.
inline float depth_at(const DepthPlane& plane, float row_depth, std::int32_t x) {
    return depth_from(plane, row_depth, depth_of_column(plane, x));
}

}  // namespace kreda::raster
