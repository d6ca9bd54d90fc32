#include "scene/files/scene_keys.hpp"

#include <algorithm>
#include <cstdio>

#include "scene/files/key_tables.hpp"

namespace kreda::scene {

namespace {

using enum KeyType;

template <class Owner>
void append(std::vector<KeyInfo>& all, const std::vector<Key<Owner>>& keys) {
    for (const Key<Owner>& key : keys) all.push_back(key.info);
}

/// In the order in which `kreda keys` prints them.
std::vector<KeyInfo> make_keys() {
    std::vector<KeyInfo> all;
    append(all, image_keys());
    append(all, camera_keys());
    append(all, shading_keys());
    append(all, ambient_keys());
    append(all, light_keys());
    append(all, shadow_keys());
    append(all, fog_keys());
    append(all, environment_keys());
    append(all, material_keys());
    append(all, object_keys());
    return all;
}

std::string plain(double number) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%g", number);
    return buffer;
}

/// " > 0", " >= 0", " in 1..8" or nothing where any number will do.
std::string range_text(const Range& range) {
    const bool unbounded_above = range.greatest >= Range{}.greatest;
    if (range.least <= Range{}.least && unbounded_above) return "";
    if (range.least == kPositive.least && unbounded_above) return " > 0";
    if (unbounded_above) return " >= " + plain(range.least);
    return std::string(range.open ? " between " : " in ") + plain(range.least) + (range.open ? " and " : "..") +
           plain(range.greatest);
}

std::string words_text(const KeyInfo& info) {
    std::string text;
    for (const std::string_view word : info.words) {
        text += (text.empty() ? "\"" : " | \"") + std::string(word) + "\"";
    }
    return text;
}

}  // namespace

const std::vector<KeyInfo>& scene_keys() {
    static const std::vector<KeyInfo> keys = make_keys();
    return keys;
}

const KeyInfo* find_key(std::string_view table, std::string_view key) {
    for (const KeyInfo& info : scene_keys()) {
        if (info.table == table && info.key == key) return &info;
    }
    return nullptr;
}

std::vector<std::string> table_names() {
    std::vector<std::string> names;
    for (const KeyInfo& info : scene_keys()) {
        if (names.empty() || names.back() != info.table) names.emplace_back(info.table);
    }
    return names;
}

std::vector<std::string> key_names(std::string_view table) {
    std::vector<std::string> names;
    for (const KeyInfo& info : scene_keys()) {
        if (info.table == table) names.emplace_back(info.key);
    }
    return names;
}

bool is_repeated(std::string_view table) {
    return table == "light" || table == "material" || table == "object";
}

std::string table_title(std::string_view table) {
    const std::string name(table);
    return is_repeated(table) ? "[[" + name + "]]" : "[" + name + "]";
}

std::string type_text(const KeyInfo& info) {
    const std::string range = range_text(info.range);
    switch (info.type) {
        case boolean: return "true or false";
        case whole: return "a whole number" + range;
        case whole_pair: return "2 whole numbers" + range;
        case number: return "a number" + range;
        case number_pair: return "2 numbers" + range;
        case vector: return "3 numbers" + range;
        case number_or_vector: return "a number or 3 numbers" + range;
        case vector_or_word: return "3 numbers" + range + " or " + words_text(info);
        case word: return words_text(info);
        case text: return "text in quotes";
        case texts: return "a list of texts in quotes";
    }
    return "";
}

std::string default_text(const KeyInfo& info) {
    return std::string(info.key) + (info.default_value.empty() ? "" : " = " + info.default_value);
}

std::string example_text(const KeyInfo& info) {
    const std::string_view value = info.example.empty() ? info.default_value : info.example;
    return std::string(info.key) + " = " + std::string(value);
}

}  // namespace kreda::scene
