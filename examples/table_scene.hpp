// The table of the shadow examples: a box, a ball and a pillar under a lamp that hangs lower than the pillar is high.
#pragma once

#include "examples/lit_scene.hpp"

namespace kreda::examples {

/// Places of the things on the table; all its tests know them.
inline const glm::vec2 kTableHalfSize{1.6f, 1.1f};                           ///< x, z; its top is at y = 0
inline const glm::vec3 kBoxCentre{-0.6f, 0.25f, 0.3f}, kBoxHalfSize{0.25f};  ///< stands on the table
inline const glm::vec3 kBallCentre{0.35f, 0.6f, 0.25f};                      ///< hovers
inline constexpr float kBallRadius = 0.3f;
inline const glm::vec3 kPillarCentre{-0.1f, 0.8f, -0.45f}, kPillarHalfSize{0.09f, 0.8f, 0.09f};
inline const glm::vec3 kLampPosition{1.0f, 1.35f, 0.15f};

/// The scene, its lamp casting shadows by rays (`shadow.method = "exact"`), samples x samples a
/// pixel.
[[nodiscard]] scene::Scene table_scene(glm::ivec2 size, int samples = 1);

/// The same things under the sun, which casts shadows by a map (`shadow.method = "map"`).
[[nodiscard]] scene::Scene sunny_table(glm::ivec2 size, int samples = 1);

/// The same, seen close: the box, and the shadow of the ball beside it.
[[nodiscard]] scene::Scene sunny_table_closely(glm::ivec2 size, int samples = 1);

/// Add a built-in shape, scaled and then moved. Returns its number.
int add_scaled_shape(scene::Scene& scene, const std::string& shape, int detail, const glm::vec3& position,
                     const glm::vec3& scale, const lighting::Material& material);

/// The shadow factor of the lamp at every sample of the picture, as the scene's method finds it: 1 lit .. 0 in shadow.
[[nodiscard]] raster::AlignedVector<float> shadow_factors(const scene::Scene& scene);

}  // namespace kreda::examples
