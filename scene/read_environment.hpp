// The [environment] table of a scene file.
#pragma once

#include <string>
#include <vector>

#include "scene/environment.hpp"
#include "scene/toml_tree.hpp"

namespace kreda::scene {

/// Reads the table and, unless it is off, its image; what had to be repaired there is a warning. Relative paths start at
/// `folder`. Throws UserError.
[[nodiscard]] EnvironmentSettings read_environment(const Value& table, const std::string& folder,
                                                   std::vector<std::string>& warnings);

}  // namespace kreda::scene
