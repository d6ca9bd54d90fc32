// Checks a parsed scene file against the table of keys: afterwards every value has its type and lies in its range.
#pragma once

#include <glm/vec3.hpp>

#include "scene/files/scene_keys.hpp"
#include "scene/files/toml_tree.hpp"

namespace kreda::scene {

/// Every table is known, built, and written as it should be: [camera] once, [[light]] as often as needed.
void check_tables(const Value& root);

/// Every key is known and built, every value has the right type and range. Requires check_tables.
void check_keys(const Value& root);

/// Complain about the value of a key: "'near' in [camera] is -1; expected a number > 0, e.g. near = 0.1".
[[noreturn]] void throw_unexpected(const Place& place, const KeyInfo& info, const std::string& found);

// Reading after the check: a key that is absent leaves `result` as it is.
void read(const Value& table, std::string_view key, bool& result);
void read(const Value& table, std::string_view key, int& result);
void read(const Value& table, std::string_view key, float& result);
void read(const Value& table, std::string_view key, glm::vec3& result);
void read(const Value& table, std::string_view key, glm::dvec3& result);
void read(const Value& table, std::string_view key, std::string& result);

/// The position of a word among the words of its key; -1 when the key is absent.
[[nodiscard]] int word_index(const Value& table, std::string_view key);

/// A word becomes the enumerator at the same position.
template <typename Enumeration>
void read_word(const Value& table, std::string_view key, Enumeration& result) {
    const int index = word_index(table, key);
    if (index >= 0) result = static_cast<Enumeration>(index);
}

}  // namespace kreda::scene
