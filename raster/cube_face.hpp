// The face of a cube that a direction points through: of a cube map, or of a lamp's six shadow maps.
#pragma once

#include <cmath>

#include <glm/vec3.hpp>

namespace kreda::raster {

/// Faces are numbered +x, -x, +y, -y, +z, -z.
inline constexpr int kCubeFaces = 6;

/// One face of a cube around the origin: which axis it stands on, and which way.
struct CubeFace {
    int face = 0;        ///< 0..5: +x, -x, +y, -y, +z, -z
    float sign = 1.0f;   ///< of the greatest coordinate: -1 or 1
    float along = 0.0f;  ///< the greatest coordinate, with its sign

    /// Does it stand on the x axis?
    [[nodiscard]] bool on_x() const {
        return face < 2;
    }
    /// Does it stand on the y axis?
    [[nodiscard]] bool on_y() const {
        return (face >= 2) & (face < 4);
    }
};

/// The face in a direction of any length, without a branch; where two coordinates are equally great x comes before y
/// before z.
inline CubeFace cube_face(const glm::vec3& d) {
    const float x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
    const bool on_x = (x >= y) & (x >= z);
    const bool on_y = !on_x & (y >= z);
    const float y_or_z = on_y ? d.y : d.z;
    const float along = on_x ? d.x : y_or_z;
    const int pair = on_x ? 0 : (on_y ? 2 : 4);
    return {pair + (along < 0.0f ? 1 : 0), along < 0.0f ? -1.0f : 1.0f, along};
}

}  // namespace kreda::raster
