// Fog as plain data: what the [fog] table of a scene says. The formulas are lighting/fog.hpp.
#pragma once

#include <glm/vec3.hpp>

namespace kreda::lighting {

/// Which equation gives the fog factor (docs/30_fog.md).
enum class FogMode { none, linear, exp, exp2 };
/// Which distance from the eye the fog counts (docs/31_fog_distance.md).
enum class FogDistance { radial, planar };
/// Where the factor is computed (docs/32_fog_per_vertex.md).
enum class FogFrequency { pixel, vertex };

/// The [fog] table of a scene.
struct Fog {
    FogMode mode = FogMode::none;                  ///< none: there is no fog
    glm::vec3 color{0.6f, 0.65f, 0.7f};            ///< c_f, linear RGB
    float start = 5.0f;                            ///< linear: z_start, world units
    float end = 30.0f;                             ///< linear: z_end, world units
    float density = 0.1f;                          ///< exp, exp2: d_f, per world unit, >= 0
    FogDistance distance = FogDistance::radial;    ///< what z of the formulas is: along the ray or along the axis
    FogFrequency frequency = FogFrequency::pixel;  ///< where f is computed
};

}  // namespace kreda::lighting
