// Normal maps: a small tilt of the normal at every texel, told in the surface's own directions t, b, n.
#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "lighting/reflection.hpp"

namespace kreda::lighting {

/// Unit and perpendicular to each other and to n: t where u grows, b where v grows.
struct TangentFrame {
    glm::vec3 t{0.0f};  ///< tangent
    glm::vec3 b{0.0f};  ///< bitangent
};

/// t = T - (n.T) n, made unit;   b = n x t, or t x n where side < 0 (the picture is mirrored on the surface).
/// n unit; tangent T of any length; one along n or of length 0 gives t = b = 0: the normal then stays as it is.
inline TangentFrame tangent_frame(const glm::vec3& n, const glm::vec3& tangent, float side) {
    const float sign = side < 0.0f ? -1.0f : 1.0f;
    TangentFrame frame;
    frame.t = unit(tangent - n * glm::dot(n, tangent));
    frame.b = glm::cross(n, frame.t) * sign;
    return frame;
}

/// The normal that a normal map asks for   n' = m_x t + m_y b + m_z n,   made unit.              Blinn 1978
/// normal: as interpolated, of any length; m: the map's vector, +z along the normal, shorter where texels that differ
/// were averaged. m = (0, 0, 1) gives exactly unit(normal), to the last bit; m = 0 leaves the normal, too.
inline glm::vec3 bend_normal(const glm::vec3& normal, const glm::vec3& tangent, float side, const glm::vec3& m) {
    const float length = std::sqrt(glm::dot(normal, normal));
    const TangentFrame frame = tangent_frame(unit(normal), tangent, side);
    const glm::vec3 tilt = (frame.t * m.x + frame.b * m.y) * length;
    const float m_z = glm::dot(m, m) > 1e-12f ? m.z : 1.0f;
    return unit(tilt + normal * m_z);
}

/// A channel of a normal map, 0..1 as stored, to -1..1:   x = (stored - zero) / (1 - zero),   at least -1.
/// In integers no value stands for 0.5; a flat surface is written as 2^(bits-1), 128 of 255: that is exactly 0 here.
/// bits = 0: the file holds floating-point numbers, zero is 0.5.
inline float normal_component(float stored, int bits) {
    const float values = static_cast<float>(1u << bits);
    const float zero = bits > 0 ? 0.5f * values / (values - 1.0f) : 0.5f;
    const float x = (stored - zero) / (1.0f - zero);
    return x > -1.0f ? x : -1.0f;
}

}  // namespace kreda::lighting
