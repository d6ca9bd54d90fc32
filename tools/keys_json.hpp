// The table of keys, and a scene file as it was read, for programs that make controls of them.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scene/files/toml_tree.hpp"

namespace kreda::tools {

/// Every key of a scene file, in the order of `kreda keys`: table, repeated (may the table be there several times),
/// key, type, meaning, words, default and example as JSON values (null: there is none), least, greatest, open.
[[nodiscard]] nlohmann::ordered_json keys_as_json();

/// A value of a scene file as JSON has it: tables are objects, repeated tables arrays of them.
[[nodiscard]] nlohmann::ordered_json as_json(const scene::Value& value);

}  // namespace kreda::tools
