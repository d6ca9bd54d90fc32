// How a depth buffer may keep depth: as a fraction of 16 or 24 bits or as a float, with 0 or with 1 at the near plane.
// Distances are eye distances along the view direction, n < z < f: the near plane, the surface, the far plane.
#pragma once

#include <cmath>
#include <limits>

namespace kreda::raster {

/// How a depth is stored (docs/95_depth_precision.md).
enum class DepthFormat { unorm16, unorm24, float32, reversed_float32 };

/// What the projection makes of a distance, before it is stored   d = f (z - n) / (z (f - n)).   0 near .. 1 far
inline double window_depth(double z, double n, double f) {
    return f * (z - n) / (z * (f - n));
}

/// The other way round   1 - d = n (f - z) / (z (f - n)).   1 near .. 0 far, where a float has the most digits to spare
inline double reversed_depth(double z, double n, double f) {
    return n * (f - z) / (z * (f - n));
}

/// How many steps there are between 0 and 1 in a format of whole numbers.
inline double steps_of(DepthFormat format) {
    return format == DepthFormat::unorm16 ? 65535.0 : 16777215.0;
}

/// What the buffer holds of a surface at distance z: rounded once, to the nearest value of the format.
inline double stored_depth(DepthFormat format, double z, double n, double f) {
    if (format == DepthFormat::reversed_float32) return static_cast<float>(reversed_depth(z, n, f));
    const double depth = window_depth(z, n, f);
    if (format == DepthFormat::float32) return static_cast<float>(depth);
    const double steps = steps_of(format);
    return std::round(depth * steps) / steps;
}

/// Does a surface with this stored depth hide what the buffer holds? Equal depths do not.
inline bool is_nearer(DepthFormat format, double depth, double in_buffer) {
    return format == DepthFormat::reversed_float32 ? depth > in_buffer : depth < in_buffer;
}

/// How far two surfaces around distance z must be apart to be stored differently: one step of the format over the slope
/// |dd/dz| = f n / (z^2 (f - n)).   With b bits: z^2 (f - n) / (f n 2^b). Reversed float: at most z 2^-23, for any n
/// and f.
inline double depth_step(DepthFormat format, double z, double n, double f) {
    const double depth = stored_depth(format, z, n, f);
    const float next = std::nextafter(static_cast<float>(depth), std::numeric_limits<float>::infinity());
    const bool is_float = format == DepthFormat::float32 || format == DepthFormat::reversed_float32;
    const double step = is_float ? double{next} - double{static_cast<float>(depth)} : 1.0 / steps_of(format);
    return step * z * z * (f - n) / (f * n);
}

}  // namespace kreda::raster
