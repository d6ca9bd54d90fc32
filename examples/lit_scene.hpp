// Scenes built in code: what the lighting examples share. Nothing here is a lesson; each line is a line of a scene file.
#pragma once

#include <string>

#include <glm/mat4x4.hpp>

#include "examples/draw.hpp"
#include "scene/scene.hpp"

namespace kreda::examples {

/// A blackboard without objects and lights, each pixel the mean of 3 x 3 samples.
[[nodiscard]] scene::Scene empty_scene(glm::ivec2 size);

/// Add a built-in shape, moved to `position`. Returns its number.
int add_shape(scene::Scene& scene, const std::string& shape, int detail, const glm::vec3& position,
              const lighting::Material& material);

/// A material of the lecture's model with m_A = 0.15 m_D, a white highlight m_S = 0.4, and exponent h.
[[nodiscard]] lighting::Material shiny(const glm::vec3& m_D, float shininess,
                                       lighting::ReflectionModel model = lighting::ReflectionModel::phong);

/// The same without highlight.
[[nodiscard]] lighting::Material matte(const glm::vec3& m_D);

[[nodiscard]] lighting::Light directional_light(const glm::vec3& direction, float intensity = 1.0f);
[[nodiscard]] lighting::Light point_light(const glm::vec3& position, float intensity = 1.0f);

/// Render the scene and write a caption on the picture.
[[nodiscard]] Image captioned(const scene::Scene& scene, const std::string& caption, int picture_height);

/// |a - b|, `gain` times as bright.
[[nodiscard]] Image difference_picture(const Image& a, const Image& b, float gain);

}  // namespace kreda::examples
