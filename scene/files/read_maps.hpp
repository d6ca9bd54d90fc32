// The keys of a [[material]] that name textures.
#pragma once

#include <string>

#include "scene/files/toml_tree.hpp"
#include "scene/scene.hpp"

namespace kreda::scene {

/// Reads albedo_map .. normal_map, maps, normal_map_y, texture_filter, texture_scale, texture_wrap into material.maps:
/// the names of files that exist, nothing is loaded. Requires that material.model was read. Relative paths start at
/// `folder`. A map that the model does not read is a warning. Throws UserError.
void read_maps(const Value& table, const std::string& folder, lighting::Material& material,
               std::vector<std::string>& warnings);

}  // namespace kreda::scene
