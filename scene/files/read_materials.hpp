// The [[material]] tables of a scene file.
#pragma once

#include <string>

#include "scene/files/toml_tree.hpp"
#include "scene/scene.hpp"

namespace kreda::scene {

/// Append a material for each table; paths in it start at `folder`. Throws UserError where keys contradict each other
/// or a name comes twice.
void read_materials(const Value& tables, const std::string& folder, Scene& scene);

}  // namespace kreda::scene
