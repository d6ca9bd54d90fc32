// [[object]]: loads its mesh, gives each part its material, places it in the world.
#pragma once

#include <string>

#include "scene/files/read_scene.hpp"
#include "scene/files/toml_tree.hpp"

namespace kreda::scene {

/// Reads all objects into the scene and appends the materials that their mesh files bring along. Requires check_keys,
/// and that scene.materials holds the [[material]]s. Relative paths start at `folder`.
void read_objects(const Value& root, const std::string& folder, const ReadOptions& options, Scene& scene);

/// world_from_object = T Rz Ry Rx S: scale, turn about x, then y, then z (degrees), move. In double, rounded once.
[[nodiscard]] glm::mat4 world_from_object(glm::vec3 translate, glm::vec3 rotate_deg, glm::vec3 scale);

}  // namespace kreda::scene
