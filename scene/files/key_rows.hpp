// A row of the table of keys: the key, the member of a struct that it sets, what it means and what may be written. Type
// and default follow from the member.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/files/scene_keys.hpp"
#include "scene/files/toml_tree.hpp"

namespace kreda::scene {

/// A key of a table that fills an Owner.
template <class Owner>
struct Key {
    KeyInfo info;
    std::function<void(const Value&, Owner&)> set;  ///< empty: whoever reads the table sees to it
};

/// What a row may say besides.
struct RowText {
    Range range = {};
    std::vector<std::string_view> words = {};  ///< in the order of the enumerators that they stand for
    std::string_view example{};                ///< where the default is none, or a poor example
    std::optional<std::string> by_default =
        std::nullopt;  ///< where what holds without the key is not the member's value
};

// ---- by the type of the member: how it is written, as what, and how it is set ------------------------------------

[[nodiscard]] std::string text_of(bool value);
[[nodiscard]] std::string text_of(int value);
[[nodiscard]] std::string text_of(float value);
[[nodiscard]] std::string text_of(const glm::vec2& value);
[[nodiscard]] std::string text_of(const glm::vec3& value);
[[nodiscard]] std::string text_of(const glm::dvec3& value);
[[nodiscard]] std::string text_of(const std::string& value);  ///< "" where it is empty: nothing holds without the key

/// Values that were checked: they are of the key's type.
void set_member(const Value& value, bool& member);
void set_member(const Value& value, int& member);
void set_member(const Value& value, float& member);
void set_member(const Value& value, glm::vec2& member);
void set_member(const Value& value, glm::vec3& member);
void set_member(const Value& value, glm::dvec3& member);
void set_member(const Value& value, std::string& member);

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

template <class T>
KeyType type_of(const RowText& more) {
    if constexpr (IsOptional<T>::value) return type_of<typename T::value_type>(more);
    if constexpr (std::is_same_v<T, bool>) return KeyType::boolean;
    if constexpr (std::is_same_v<T, int>) return KeyType::whole;
    if constexpr (std::is_same_v<T, float>) return KeyType::number;
    if constexpr (std::is_same_v<T, glm::vec2>) return KeyType::number_pair;
    if constexpr (std::is_same_v<T, glm::vec3> || std::is_same_v<T, glm::dvec3>) return KeyType::vector;
    return std::is_enum_v<T> || !more.words.empty() ? KeyType::word : KeyType::text;
}

template <class T>
std::string default_of(const T& value, const RowText& more) {
    if (more.by_default) return *more.by_default;
    if constexpr (IsOptional<T>::value) {
        return "";
    } else if constexpr (std::is_enum_v<T>) {
        return text_of(std::string(more.words[static_cast<std::size_t>(value)]));
    } else {
        return text_of(value);
    }
}

template <class T>
void set_by_type(const Value& value, const std::vector<std::string_view>& words, T& member) {
    if constexpr (IsOptional<T>::value) {
        set_member(value, member.emplace());
    } else if constexpr (std::is_enum_v<T>) {
        for (std::size_t i = 0; i < words.size(); ++i) {
            if (words[i] == value.text) member = static_cast<T>(i);
        }
    } else {
        set_member(value, member);
    }
}

// ---- rows --------------------------------------------------------------------------------------------------------

/// A member of a member, for row(): within(&Material::phong, &PhongMaterial::ambient).
template <class Outer, class Inner>
auto within(Outer outer, Inner inner) {
    return [=](auto& owner) -> auto& {
        return owner.*outer.*inner;
    };
}

/// `member`: a pointer to a member of Owner, or within(...).
template <class Owner, class Member>
Key<Owner> row(std::string_view key, Member member, std::string_view meaning, const RowText& more = {}) {
    Owner implied;
    using T = std::remove_cvref_t<decltype(std::invoke(member, implied))>;
    const KeyInfo info{"",      key,        type_of<T>(more), default_of<T>(std::invoke(member, implied), more),
                       meaning, more.range, more.words,       more.example};
    return {info, [member, words = more.words](const Value& value, Owner& owner) {
                set_by_type(value, words, std::invoke(member, owner));
            }};
}

/// Two numbers for two members.
template <class Owner, class Number>
Key<Owner> pair_row(std::string_view key, Number Owner::*first, Number Owner::*second, std::string_view meaning,
                    const RowText& more) {
    const Owner implied;
    const KeyType type = std::is_same_v<Number, int> ? KeyType::whole_pair : KeyType::number_pair;
    const std::string by_default = "[" + text_of(implied.*first) + ", " + text_of(implied.*second) + "]";
    return {{"", key, type, by_default, meaning, more.range, more.words, more.example},
            [=](const Value& value, Owner& owner) {
                set_member(value.items[0], owner.*first);
                set_member(value.items[1], owner.*second);
            }};
}

/// A key of a type of its own, or one that whoever reads the table sees to (`set` empty).
template <class Owner>
Key<Owner> own_row(std::string_view key, KeyType type, std::string_view meaning, const RowText& more = {},
                   std::function<void(const Value&, Owner&)> set = {}) {
    return {{"", key, type, more.by_default.value_or(""), meaning, more.range, more.words, more.example},
            std::move(set)};
}

/// The rows of one table of the file.
template <class Owner>
std::vector<Key<Owner>> rows_of(std::string_view table, std::vector<Key<Owner>> keys) {
    for (Key<Owner>& key : keys) key.info.table = table;
    return keys;
}

/// Set what the table gives; the rest of `owner` stays.
template <class Owner>
void read_keys(const Value& table, const std::vector<Key<Owner>>& keys, Owner& owner) {
    for (const Key<Owner>& key : keys) {
        const Value* const value = key.set ? find(table, key.info.key) : nullptr;
        if (value) key.set(*value, owner);
    }
}

}  // namespace kreda::scene
