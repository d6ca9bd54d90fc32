#include "scene/files/key_rows.hpp"

#include <cstdio>

namespace kreda::scene {

namespace {

/// Six digits: a float's value as people write it.
std::string digits(double number) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%g", number);
    return buffer;
}

template <class Vector>
std::string list(const Vector& vector) {
    std::string text = "[";
    for (int i = 0; i < Vector::length(); ++i) text += (i > 0 ? ", " : "") + digits(static_cast<double>(vector[i]));
    return text + "]";
}

template <class Vector>
void set_vector(const Value& value, Vector& member) {
    for (int i = 0; i < Vector::length(); ++i) {
        member[i] = static_cast<typename Vector::value_type>(value.items[static_cast<std::size_t>(i)].number);
    }
}

}  // namespace

std::string text_of(bool value) {
    return value ? "true" : "false";
}
std::string text_of(int value) {
    return std::to_string(value);
}
std::string text_of(float value) {
    return digits(static_cast<double>(value));
}
std::string text_of(const glm::vec2& value) {
    return list(value);
}
std::string text_of(const glm::vec3& value) {
    return list(value);
}
std::string text_of(const glm::dvec3& value) {
    return list(value);
}
std::string text_of(const std::string& value) {
    return value.empty() ? "" : in_quotes(value, '"');
}

void set_member(const Value& value, bool& member) {
    member = value.boolean;
}
void set_member(const Value& value, int& member) {
    member = static_cast<int>(value.integer);
}
void set_member(const Value& value, float& member) {
    member = static_cast<float>(value.number);
}
void set_member(const Value& value, glm::vec2& member) {
    set_vector(value, member);
}
void set_member(const Value& value, glm::vec3& member) {
    set_vector(value, member);
}
void set_member(const Value& value, glm::dvec3& member) {
    set_vector(value, member);
}
void set_member(const Value& value, std::string& member) {
    member = value.text;
}

}  // namespace kreda::scene
