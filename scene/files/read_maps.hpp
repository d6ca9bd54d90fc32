// The keys of a [[material]] that name textures.
#pragma once

#include <string>

#include "scene/files/toml_tree.hpp"
#include "scene/scene.hpp"

namespace kreda::scene {

/// Reads maps, albedo_map .. normal_map and bump_map into material.maps: the names of files that exist, nothing is
/// loaded. An emission map without `emission` beside it makes that 1. Requires that the other keys of the material were
/// read. Relative paths start at `folder`. A map that the model does not read is a warning. Throws UserError.
void read_maps(const Value& table, const std::string& folder, lighting::Material& material,
               std::vector<std::string>& warnings);

}  // namespace kreda::scene
