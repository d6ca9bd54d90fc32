// Three unit vectors at right angles: the directions of a surface whose normal alone is known.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace kreda::raster {

/// Right-handed: t x b = n.
struct OrthonormalFrame {
    glm::vec3 t, b, n;  ///< unit, at right angles
};

/// Two directions that make a right-handed frame with n (unit), without a branch.                    Duff et al. 2017
inline OrthonormalFrame frame_around(const glm::vec3& n) {
    const float sign = n.z < 0.0f ? -1.0f : 1.0f;
    const float a = -1.0f / (sign + n.z);
    const float b = n.x * n.y * a;
    return {{1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

/// From the frame's coordinates to those that its vectors are given in.
inline glm::vec3 to_world(const OrthonormalFrame& frame, const glm::vec3& d) {
    return frame.t * d.x + frame.b * d.y + frame.n * d.z;
}

/// And back.
inline glm::vec3 to_surface(const OrthonormalFrame& frame, const glm::vec3& d) {
    return {glm::dot(frame.t, d), glm::dot(frame.b, d), glm::dot(frame.n, d)};
}

}  // namespace kreda::raster
