// Scenes built in code: what the lighting examples share. Nothing here is a lesson; each line is a line of a scene
// file.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "examples/example.hpp"
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

/// Directional lights spread evenly over all directions (a spiral of equal areas), which together send what a sphere of
/// this radiance all around would: radiance(d) x 4 pi / count from direction d. On surfaces too rough to mirror single
/// lights they look like that sphere.
[[nodiscard]] std::vector<lighting::Light> lights_all_around(
    int count, const std::function<glm::vec3(const glm::vec3&)>& radiance);

/// Radiance of a photographer's studio: a large soft lamp above on the left, a warm one on the right, a grey floor.
[[nodiscard]] glm::vec3 studio(const glm::vec3& direction);

/// A material of Cook and Torrance's model: GGX, height-correlated Smith.
[[nodiscard]] lighting::Material microfacet(const glm::vec3& albedo, float metallic, float roughness);

/// Render the scene to linear radiance, with a caption.
[[nodiscard]] Panel captioned(const scene::Scene& scene, const std::string& caption);

/// Render to linear radiance as the scene says in a draft; else light once a pixel and take 3 x 3 samples of the
/// outline alone. For pictures of things before an even background, with too many lights for nine samples.
[[nodiscard]] Image render_outlined(const Options& options, const scene::Scene& scene);

/// |a - b|, `gain` times as bright.
[[nodiscard]] Image difference_picture(const Image& a, const Image& b, float gain);

}  // namespace kreda::examples
