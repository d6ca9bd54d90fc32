// Light sources as plain data. What each of them sends to a point of a surface: lighting/light_sample.hpp.
#pragma once

#include <glm/vec3.hpp>

namespace kreda::lighting {

/// The sun, a lamp, or a lamp in a cone.
enum class LightType { directional, point, spot };

/// Weakening with distance d:  1 / (constant + linear d + quadratic d^2).  "physical" is {0, 0, 1}.
struct Attenuation {
    float constant = 1.0f;   ///< >= 0
    float linear = 0.0f;     ///< per world unit, >= 0
    float quadratic = 0.0f;  ///< per square of a world unit, >= 0
};

/// One light source. Which fields count depends on its type.
struct Light {
    LightType type = LightType::directional;  ///< decides which fields count
    glm::vec3 direction{-1.0f, -2.0f,
                        -1.0f};  ///< directional, spot: the way the light travels, world space, any length > 0
    glm::vec3 position{2.0f, 3.0f, 1.0f};  ///< point, spot: world space
    glm::vec3 color{1.0f};                 ///< s, linear RGB
    float intensity = 1.0f;                ///< multiplies color
    Attenuation attenuation;               ///< point, spot
    float inner_cone_deg = 20.0f;          ///< spot: full light inside this half-angle
    float outer_cone_deg = 30.0f;          ///< spot: no light outside this half-angle
    bool shadow = false;                   ///< casts shadows
    bool on = true;                        ///< false: as if it were not in the scene
};

/// The most light that may arrive at a point, whatever its distance: 1 / d^2 has no bound, and infinity times the
/// cosine 0 is no number. Terms of materials, at most 1e19 of it, stay finite, too.
inline constexpr float kMostIrradiance = 1e18f;

/// A light made ready for a frame: lengths and cosines that are the same for every point.
struct LightSetup {
    LightType type = LightType::directional;   ///< decides which fields count
    glm::vec3 position{0.0f};                  ///< world space
    glm::vec3 axis{0.0f};                      ///< unit, the way the light travels, world space
    glm::vec3 radiance{1.0f};                  ///< color x intensity
    Attenuation attenuation;                   ///< point, spot
    float most_weight = kMostIrradiance;       ///< what the attenuation may be at most
    float cos_inner = 1.0f, cos_outer = 0.0f;  ///< spot: of the half-angles of its cones
};

/// What does not change from point to point: unit axis, cosines of the cone, color times intensity.
[[nodiscard]] LightSetup prepare(const Light& light);

}  // namespace kreda::lighting
