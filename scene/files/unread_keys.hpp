// Keys of a material that its model does not read, and colours that look like bytes: said once, where they stand.
#pragma once

#include <string>
#include <vector>

#include "lighting/material.hpp"
#include "scene/files/toml_tree.hpp"

namespace kreda::scene {

/// A line for each key of a [[material]] that the material's model never looks at, with what it reads instead.
[[nodiscard]] std::vector<std::string> unread_keys(const Value& table, const lighting::Material& material);

/// A line for each colour anywhere in the scene file whose three numbers look like bytes of 0..255.
[[nodiscard]] std::vector<std::string> byte_colors(const Value& root);

}  // namespace kreda::scene
