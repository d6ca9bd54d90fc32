// [[object]]: loads its mesh, gives each part its material, places it in the world.
#pragma once

#include <string>

#include <glm/mat4x4.hpp>

#include "scene/files/place_scene.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/files/toml_tree.hpp"

namespace kreda::scene {

/// Reads all objects into the scene and appends the materials that their mesh files bring along. Requires check_keys,
/// and that scene.materials holds the [[material]]s. Relative paths start at `folder`. Where the objects are is added
/// to `placements`; place_scene() computes their matrices from it.
void read_objects(const Value& root, const std::string& folder, const ReadOptions& options, Placements& placements,
                  Scene& scene);

/// T Rz Ry Rx S: scale, turn about x, then y, then z (degrees), move.
[[nodiscard]] glm::dmat4 placed(const glm::dvec3& translate, const glm::dvec3& rotate_deg, const glm::dvec3& scale);

/// world_from_object = T Rz Ry Rx S, computed in double and rounded once.
[[nodiscard]] glm::mat4 world_from_object(glm::vec3 translate, glm::vec3 rotate_deg, glm::vec3 scale);

}  // namespace kreda::scene
