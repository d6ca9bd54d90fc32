// Clipping in homogeneous coordinates, before the divide, so that w is never near zero after it.
#pragma once

#include <array>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace kreda::raster {

/// A corner of a clipped polygon: its clip-space position, and its weights in the triangle it was cut from.
struct ClipVertex {
    glm::vec4 position{0.0f};  ///< clip space
    glm::vec3 weights{0.0f};   ///< of the triangle's three corners, sum 1; attributes are interpolated with them
};

/// A convex polygon. A triangle has 3 corners and each of six planes adds at most one, so 9 would do; where rounding
/// makes a sliver cross a plane more than twice there may be a few more.
struct ClipPolygon {
    static constexpr int kMaxCorners = 16;       ///< room for all of them
    std::array<ClipVertex, kMaxCorners> vertex;  ///< clip space, in their order around it; the first `count` of them
    int count = 0;                               ///< corners; 0: nothing is left
};

/// Which side of the far plane is asked for. Pictures want what lies before it; shadow volumes reach beyond it.
enum class FarSide { before, beyond };

/// The part of the triangle a, b, c inside the near and far plane and the guard band
///   -w <= z <= w,   |x| <= guard_x w,   |y| <= guard_y w;   beyond the far plane: w <= z instead.
/// Every corner satisfies inside_guard_band(), but for z <= w if it lies beyond. Both parts of a triangle meet in the
/// same corners. Empty (count 0) when nothing of area is left or a coordinate is not finite.  Sutherland & Hodgman 1974
[[nodiscard]] ClipPolygon clip_triangle(const glm::vec4& a, const glm::vec4& b, const glm::vec4& c, float guard_x,
                                        float guard_y, FarSide side = FarSide::before);

}  // namespace kreda::raster
