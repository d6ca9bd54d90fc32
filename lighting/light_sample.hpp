// What each light source sends to a point of a surface: direction, attenuation, cone.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "lighting/light.hpp"
#include "raster/scalar_math.hpp"
#include "raster/unit_vector.hpp"

namespace kreda::lighting {

/// What a light sends to one point of a surface.
struct LightSample {
    glm::vec3 l;           ///< unit, surface -> light, world space
    glm::vec3 irradiance;  ///< s(p): color x intensity x attenuation x cone; what a plane facing the light receives
};

/// Attenuation at distance d >= 0, which counts as 1e18 beyond that: infinity times 0 is no number.          [1]
/// Coefficients in [0, 1e9]; infinite where all terms are 0.
inline float attenuate(const Attenuation& a, float d) {
    const float near = raster::smaller_of_positive(d, 1e18f);
    return 1.0f / (a.constant + a.linear * near + a.quadratic * near * near);
}

/// Smooth step from 1 inside the inner cone to 0 outside the outer one: 3t^2 - 2t^3.   [0, 1]
/// cos_angle is the cosine between the spot's axis and the ray to the surface; cos_inner >= cos_outer.
inline float spot_cone(float cos_angle, float cos_inner, float cos_outer) {
    const float width = cos_inner - cos_outer;
    const float sharp = cos_angle >= cos_outer ? 1.0f : 0.0f;
    const float ramp = raster::saturate((cos_angle - cos_outer) / (width > 0.0f ? width : 1.0f));
    const float t = width > 0.0f ? ramp : sharp;
    return raster::smooth_ramp(t);
}

/// A directional light shines from the same side everywhere, with the same strength.
inline LightSample sample_directional(const LightSetup& light) {
    return {-light.axis, light.radiance};
}

/// A point light shines to all sides from its position and weakens with distance. At the light itself (d = 0) there is
/// no direction: l is 0 and nothing is lit.
inline LightSample sample_point(const LightSetup& light, const glm::vec3& p) {
    const glm::vec3 to_light = light.position - p;
    const float d = raster::divisible_length(to_light);
    LightSample sample;
    sample.l = to_light * (1.0f / d);
    sample.irradiance =
        light.radiance * raster::smaller_of_positive(attenuate(light.attenuation, d), light.most_weight);
    return sample;
}

/// A spot light is a point light inside a cone around its axis.
inline LightSample sample_spot(const LightSetup& light, const glm::vec3& p) {
    LightSample sample = sample_point(light, p);
    const float cos_angle = -glm::dot(sample.l, light.axis);
    sample.irradiance *= spot_cone(cos_angle, light.cos_inner, light.cos_outer);
    return sample;
}

/// The light at one point p of a surface, whatever its type (world space).
[[nodiscard]] LightSample sample(const Light& light, const glm::vec3& p);

}  // namespace kreda::lighting
