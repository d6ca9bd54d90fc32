// Directions chosen where they matter: evenly spread numbers, and the lobes they are turned into.
// In the frame of a surface n = (0, 0, 1). No C library inside: the same directions on every machine.
#pragma once

#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lighting/reflection.hpp"
#include "raster/orthonormal_frame.hpp"
#include "raster/trigonometry.hpp"

namespace kreda::lighting {

using raster::frame_around;
using raster::to_surface;
using raster::to_world;

/// The bits of i mirrored at the binary point, in [0, 1): 1 -> 1/2, 2 -> 1/4, 3 -> 3/4.               van der Corput
/// 1935
inline float radical_inverse(std::uint32_t i) {
    i = (i << 16) | (i >> 16);
    i = ((i & 0x55555555u) << 1) | ((i & 0xaaaaaaaau) >> 1);
    i = ((i & 0x33333333u) << 2) | ((i & 0xccccccccu) >> 2);
    i = ((i & 0x0f0f0f0fu) << 4) | ((i & 0xf0f0f0f0u) >> 4);
    i = ((i & 0x00ff00ffu) << 8) | ((i & 0xff00ff00u) >> 8);
    return static_cast<float>(i >> 8) * 5.9604644775390625e-8f;  // 24 bits, 2^-24: always below 1
}

/// Point i of n spread evenly over the unit square   ((i + 1/2) / n, radical inverse + 1 / 2n)         Hammersley 1960
/// The shift by half a step keeps every point off the square's border.
inline glm::vec2 hammersley(int i, int n) {
    const float step = 1.0f / static_cast<float>(n);
    const float second = radical_inverse(static_cast<std::uint32_t>(i)) + 0.5f * step;
    return {(static_cast<float>(i) + 0.5f) * step, second < 1.0f ? second : 0.99999994f};
}

/// The direction, unit, with this cosine in [-1, 1] to n, `turns` around it, |turns| < 2^20.
inline glm::vec3 around_normal(float cosine, float turns) {
    const raster::SinCos phi = raster::sin_cos_of_turns(turns);
    const float sin2 = (1.0f - cosine) * (1.0f + cosine);
    const float sine = std::sqrt(sin2 > 0.0f ? sin2 : 0.0f);
    return {sine * phi.cos, sine * phi.sin, cosine};
}

/// A direction l with density  n.l / pi.   u in [0, 1)^2.
inline glm::vec3 cosine_direction(const glm::vec2& u) {
    return around_normal(std::sqrt(1.0f - u.y), u.x);
}

/// A half vector with density  D (n.h)  of GGX.                                          Walter et al. 2007 eq. (35),
/// (36)
inline glm::vec3 ggx_half_vector(const glm::vec2& u, float alpha) {
    const float cos2 = (1.0f - u.y) / (1.0f + (alpha * alpha - 1.0f) * u.y);
    return around_normal(std::sqrt(cos2), u.x);
}

/// A half vector with the density of those facets of GGX that v sees   D_v = G_1(v) (v.h) D / (n.v).   v in the
/// surface's frame, v.z > 0; u, phi: a point of the unit square as height and angle. Stretch v, take an even point of
/// the spherical cap that it sees, squeeze back. In float for pictures, in double for tables.       Dupuy & Benyoub
/// 2023
template <class Real>
inline glm::vec<3, Real> visible_facet(const glm::vec<3, Real>& v, Real alpha, Real cos_phi, Real sin_phi, Real u) {
    constexpr Real k0{0}, k1{1}, kLeast = Real(raster::kLeastLength2);
    const glm::vec<3, Real> s = glm::normalize(glm::vec<3, Real>(alpha * v.x, alpha * v.y, v.z));
    const Real z = (k1 - u) * (k1 + s.z) - s.z;
    const Real sin2 = (k1 - z) * (k1 + z);
    const Real radius = std::sqrt(sin2 > k0 ? sin2 : k0);
    const glm::vec<3, Real> m{alpha * (radius * cos_phi + s.x), alpha * (radius * sin_phi + s.y), z + s.z};
    const Real length2 = glm::dot(m, m);
    return m * (k1 / std::sqrt(length2 > kLeast ? length2 : kLeast));
}

/// A facet that v sees, from two even numbers u in [0, 1)²; unit, n is (0, 0, 1). Heitz 2018.
inline glm::vec3 visible_half_vector(const glm::vec2& u, const glm::vec3& v, float alpha) {
    const raster::SinCos phi = raster::sin_cos_of_turns(u.x);
    return visible_facet(v, alpha, phi.cos, phi.sin, u.y);
}

}  // namespace kreda::lighting
