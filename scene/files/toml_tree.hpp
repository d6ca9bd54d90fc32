// A TOML file as a tree of plain values, each of which knows its place. Only toml_tree.cpp knows toml++.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/error.hpp"
#include "scene/files/quoted_text.hpp"

namespace kreda::scene {

enum class ValueKind { boolean, integer, number, text, date, array, table };

/// One value. Items of an array carry the key and key_place of the array.
struct Value {
    ValueKind kind = ValueKind::table;
    std::string key;  ///< its name in the table that holds it; empty for the root
    Place key_place;  ///< where the name is written
    Place place;      ///< where the value is written
    bool boolean = false;
    std::int64_t integer = 0;
    double number = 0.0;  ///< also set for an integer
    std::string text;
    std::vector<Value> items;  ///< items of an array or members of a table, in the order of the file
};

/// The tree of a TOML text; `name` stands for the file in messages. Throws UserError for anything that is not TOML.
[[nodiscard]] Value parse_toml(const std::string& text, const std::string& name);

/// The member of a table with this key, or nullptr.
[[nodiscard]] const Value* find(const Value& table, std::string_view key);
[[nodiscard]] Value* find(Value& table, std::string_view key);

/// Where the value of a key is written; where its table is, when the key is absent.
[[nodiscard]] const Place& place_of(const Value& table, std::string_view key);

/// on_one_line between quotes.
[[nodiscard]] std::string in_quotes(std::string_view text, char quote = '\'');

/// "; did you mean 'x'?" or, where nothing is near, "; known keys: a, b, c" (what = "keys").
[[nodiscard]] std::string did_you_mean(const std::string& word, const std::vector<std::string>& known,
                                       const std::string& what);

}  // namespace kreda::scene
