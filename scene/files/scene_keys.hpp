// Every key of a scene file, once: what may be written, what it means, what holds without it.
// The reader checks files against this table and `kreda keys` prints it.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace kreda::scene {

enum class KeyType {
    boolean,
    whole,       ///< a whole number
    whole_pair,  ///< [640, 360]
    number,
    number_pair,       ///< [20, 30]
    vector,            ///< [0, 1, 4]
    number_or_vector,  ///< 2 or [1, 2, 1]
    vector_or_word,    ///< [1, 0, 0] or one of `words`
    word,              ///< one of `words`
    text,
    texts,  ///< ["lid", "handle"]
};

/// Numbers outside are refused. Beyond 1e9 nothing is allowed: a product of four such numbers is still a finite float.
struct Range {
    double least = -1e9;
    double greatest = 1e9;
    bool open = false;  ///< the ends themselves are refused
};

/// Places (positions, translate) may be farther from 0 than other numbers are large: only differences of them are used.
constexpr double kFarthest = 1e25;

struct KeyInfo {
    std::string_view table;  ///< "camera"; for [[light]] "light"
    std::string_view key;
    KeyType type = KeyType::number;
    std::string_view default_value;  ///< as it is written in a file; empty: none
    std::string_view meaning;
    Range range;                          ///< for each number of the value
    std::vector<std::string_view> words;  ///< in the order of the enumerators that they stand for
    std::string_view example;             ///< where the default is empty or a poor example
};

/// All keys, in the order of the tables' first appearance in the documentation.
[[nodiscard]] const std::vector<KeyInfo>& scene_keys();

/// The entry of a key, or nullptr.
[[nodiscard]] const KeyInfo* find_key(std::string_view table, std::string_view key);

/// Names of the tables, each once, and of the keys of one table.
[[nodiscard]] std::vector<std::string> table_names();
[[nodiscard]] std::vector<std::string> key_names(std::string_view table);

/// True for the tables that may be there several times: [[light]], [[material]], [[object]].
[[nodiscard]] bool is_repeated(std::string_view table);

/// "[camera]", "[[light]]".
[[nodiscard]] std::string table_title(std::string_view table);

/// What may be written, in words: "a number > 0", "3 numbers >= 0", "\"back\" | \"front\" | \"none\"".
[[nodiscard]] std::string type_text(const KeyInfo& info);

/// "near = 0.1", what holds without the key; "measured" where nothing does.
[[nodiscard]] std::string default_text(const KeyInfo& info);

/// "near = 0.1", something to write: an example where the default is none.
[[nodiscard]] std::string example_text(const KeyInfo& info);

}  // namespace kreda::scene
