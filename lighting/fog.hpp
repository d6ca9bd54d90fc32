// Fog: a factor f in [0, 1] that falls with distance, and the mix of surface and fog colour.
// Source: Strachota 2020, "Osvetlovani a stinovani", section 5.
#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "lighting/fog_settings.hpp"
#include "raster/scalar_math.hpp"

namespace kreda::lighting {

/// Linear fog   f = (z_end - z_p) / (z_end - z_start), clipped to [0, 1].   z_p >= 0, also infinite; both ends to 1e18.
/// z_start == z_end is a wall of fog: 1 before it, 0 from it on.
inline float fog_linear(float z_p, float z_start, float z_end) {
    const float range = z_end - z_start;
    const float wall = z_p < z_end ? 1.0f : 0.0f;
    const float f = (z_end - z_p) / (range != 0.0f ? range : 1.0f);
    return range != 0.0f ? raster::saturate(f) : wall;
}

/// Exponential fog   f = exp(-d_f z_p), in [0, 1].   Clear air (d_f = 0) gives 1 at any distance.  d_f in [0, 1e30].
inline float fog_exp(float z_p, float density) {
    const float optical_depth = density > 0.0f ? density * z_p : 0.0f;
    return raster::saturate(raster::exp(-optical_depth));
}

/// Squared exponential fog   f = exp(-(d_f z_p)^2), in [0, 1].   z_p >= 0, d_f in [0, 1e30].
inline float fog_exp2(float z_p, float density) {
    const float optical_depth = density > 0.0f ? density * z_p : 0.0f;
    return raster::saturate(raster::exp(-optical_depth * optical_depth));
}

/// Distance from the plane through the eye that is parallel to the image; never negative.  forward: unit, world space.
inline float planar_distance(const glm::vec3& p, const glm::vec3& eye, const glm::vec3& forward) {
    const float z = glm::dot(p - eye, forward);
    return z > 0.0f ? z : 0.0f;
}

/// True distance from the eye: 0, or the largest component of p - eye in [1e-15, 1e18].
inline float radial_distance(const glm::vec3& p, const glm::vec3& eye) {
    const glm::vec3 d = p - eye;
    return std::sqrt(glm::dot(d, d));
}

/// c_p = f c_s + (1 - f) c_f.   f in [0, 1].   This form is exact at f = 1 and f = 0 (c_f + f (c_s - c_f) is not).
inline glm::vec3 mix_fog(float f, const glm::vec3& surface_color, const glm::vec3& fog_color) {
    return f * surface_color + (1.0f - f) * fog_color;
}

}  // namespace kreda::lighting
