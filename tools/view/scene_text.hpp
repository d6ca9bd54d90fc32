// A scene file made of a parsed one: what a viewer saves after its controls were turned.
#pragma once

#include <string>

#include "scene/files/toml_tree.hpp"

namespace kreda::tools {

/// TOML that says the same as `root` and holds no comments. Reading it gives equal values, to the last bit.
[[nodiscard]] std::string text_of_scene(const scene::Value& root);

}  // namespace kreda::tools
