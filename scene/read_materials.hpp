// The [[material]] tables of a scene file.
#pragma once

#include "scene/scene.hpp"
#include "scene/toml_tree.hpp"

namespace kreda::scene {

/// Append a material for each table. Throws UserError where keys contradict each other or a name comes twice.
void read_materials(const Value& tables, Scene& scene);

}  // namespace kreda::scene
