// Checks a parsed scene file against the table of keys: afterwards every value has its type and lies in its range.
#pragma once

#include "scene/files/scene_keys.hpp"
#include "scene/files/toml_tree.hpp"

namespace kreda::scene {

/// Every table is known, built, and written as it should be: [camera] once, [[light]] as often as needed.
void check_tables(const Value& root);

/// Every key is known and built, every value has the right type and range. Requires check_tables.
void check_keys(const Value& root);

/// Complain about the value of a key: "'near' in [camera] is -1; expected a number > 0, e.g. near = 0.1".
[[noreturn]] void throw_unexpected(const Place& place, const KeyInfo& info, const std::string& found);

}  // namespace kreda::scene
