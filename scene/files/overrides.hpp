// "--set camera.position=[0,1,4]": values from the command line, put into the parsed file before it is checked.
#pragma once

#include <string>
#include <vector>

#include "scene/files/toml_tree.hpp"

namespace kreda::scene {

/// Put each "TABLE.KEY=VALUE" into the tree. Lights and objects are named by number from 0 (light.0.intensity),
/// materials by name or number (material.gold.diffuse). A [table] that the file lacks is added.
/// environment.file takes the place of a sky, and the other way round. Requires check_tables.
void apply_overrides(Value& root, const std::vector<std::string>& overrides);

}  // namespace kreda::scene
