#include "tests/stability/extreme_scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>
#include <string_view>
#include <vector>

#include "scene/files/scene_keys.hpp"

namespace kreda::tests {

namespace {

using scene::KeyInfo;
using scene::KeyType;

/// Numbers from one seed; the library's distributions differ from one library to the next.
struct Chance {
    std::mt19937 random;

    int below(int count) {
        return static_cast<int>(random() % static_cast<std::uint32_t>(count));
    }
    bool one_in(int count) {
        return below(count) == 0;
    }
    double share() {
        return static_cast<double>(random() >> 8) * 0x1p-24;
    }
};

/// Keys whose value is a matter of time or of files, not of numbers: what they get, or "" to leave them out.
const std::map<std::string, std::string>& fixed_values() {
    static const std::map<std::string, std::string> values = {
        {"shadow.size", "32"},
        {"shadow.radius", "2"},
        {"object.detail", "6"},
        {"environment.samples", "32"},
        {"environment.reference", "16"},
        {"environment.file", ""},
        {"environment.on", ""},
        {"material.name", "\"m\""},
        {"object.material", "\"m\""},
        {"object.hide", ""},
        {"material.table_size", "16"},
        {"material.maps", ""},
        {"material.nvidia", ""},
        {"light.on", ""},
        {"material.measured", ""},
        {"material.spectrum", ""},
        {"camera.far", ""},  // beside near
        {"camera.up", ""},
        {"image.background", "[0.0, 1e-8, 1e9]"},
    };
    return values;
}

std::string number_text(double number) {
    char text[40];
    std::snprintf(text, sizeof text, "%.9g", number);
    const bool is_whole = std::string_view(text).find_first_of(".en") == std::string_view::npos;
    return is_whole ? std::string(text) + ".0" : text;
}

/// An end of the range, a plain number, or one of any magnitude.
double number_within(const KeyInfo& key, Chance& chance) {
    const double least = key.range.least, greatest = std::min(key.range.greatest, 1e9);
    const double inner = key.range.open ? 1e-6 * (greatest - least) : 0.0;
    const auto in_range = [&](double x) { return std::clamp(x, least + inner, greatest - inner); };
    const double plain[] = {0.0, 1e-8, 0.1, 0.5, 1.0, 2.0, 5.0, 30.0, -1.0, 1.0 + 1e-7};
    switch (chance.below(8)) {
        case 0: return in_range(least);
        case 1:
        case 2:
        case 3: return in_range(greatest);
        case 4: return in_range(std::exp2(60.0 * chance.share() - 30.0) * (chance.one_in(2) ? 1.0 : -1.0));
        default: return in_range(plain[chance.below(10)]);
    }
}

std::string numbers_text(const KeyInfo& key, int count, Chance& chance) {
    std::string list;
    for (int i = 0; i < count; ++i) list += (i == 0 ? "" : ", ") + number_text(number_within(key, chance));
    return "[" + list + "]";
}

std::string word_of(const KeyInfo& key, Chance& chance) {
    if (key.words.empty()) return "";
    const std::string_view word = key.words[static_cast<std::size_t>(chance.below(static_cast<int>(key.words.size())))];
    return '"' + std::string(word) + '"';
}

std::string value_of(const KeyInfo& key, Chance& chance) {
    const std::string name = std::string(key.table) + "." + std::string(key.key);
    if (const auto fixed = fixed_values().find(name); fixed != fixed_values().end()) return fixed->second;
    if (name == "image.size") {
        const char* const sizes[] = {"[24, 16]", "[24, 16]", "[17, 23]", "[1, 1]", "[40, 1]", "[1, 40]"};
        return sizes[chance.below(6)];
    }
    if (name == "image.samples") return std::to_string(1 + chance.below(3));
    if (name == "camera.near") {
        const char* const planes[] = {"1e-9\nfar = 1e9", "1e-6\nfar = 1e3", "0.1\nfar = 0.1000001", "3.0\nfar = 5.0",
                                      "1e3\nfar = 1e9"};
        return planes[chance.below(5)];
    }
    if (name == "object.mesh") {
        const char* const shapes[] = {"\"sphere\"", "\"cube\"", "\"plane\"", "\"torus\""};
        return shapes[chance.below(4)];
    }
    if (name ==
        "light.position") {  // in corners of the shapes, where vertices are lit from distance 0, and beside them
        const char* const places[] = {"[0.0, 1.0, 0.0]", "[0.0, -1.0, 0.0]",  "[1.0, 0.0, 0.0]",      "[0.0, 0.0, 0.0]",
                                      "[0.5, 0.5, 0.5]", "[-1.0, 0.0, -1.0]", "[0.0, 1.0000001, 0.0]"};
        return places[chance.below(7)];
    }
    if (name == "light.attenuation" && chance.one_in(2)) return "\"physical\"";
    if (name == "light.cone") {
        const char* const cones[] = {"[0.0, 0.0]", "[0.0, 180.0]", "[20.0, 20.00001]", "[90.0, 180.0]", "[1e-9, 30.0]"};
        return cones[chance.below(5)];
    }
    switch (key.type) {
        case KeyType::boolean: return chance.one_in(2) ? "true" : "false";
        case KeyType::whole: return number_text(std::floor(number_within(key, chance))).substr(0, 9);
        case KeyType::whole_pair:
        case KeyType::texts: return "";
        case KeyType::number: return number_text(number_within(key, chance));
        case KeyType::number_pair: return numbers_text(key, 2, chance);
        case KeyType::vector: return numbers_text(key, 3, chance);
        case KeyType::number_or_vector: return numbers_text(key, 3, chance);
        case KeyType::vector_or_word: return chance.one_in(3) ? word_of(key, chance) : numbers_text(key, 3, chance);
        case KeyType::word:
        case KeyType::text: return word_of(key, chance);
    }
    return "";
}

/// A table with some of its keys. Places are left alone half of the time, so that something is seen.
std::string table_text(const std::string& table, Chance& chance) {
    std::string text = scene::table_title(table) + "\n";
    const bool stays_put = chance.one_in(2);
    for (const KeyInfo& key : scene::scene_keys()) {
        if (key.table != table) continue;
        const bool is_place = (key.range.greatest > 1e20 && table != "light") || table == "camera";
        const bool is_map = key.key.ends_with("_map") || key.key == "bump_scale";
        const bool is_needed = key.key == "mesh" || key.key == "material" || key.key == "name" || key.key == "size" ||
                               key.key == "ior" || key.key == "sky";
        if (is_map || (is_place && stays_put) || (!is_needed && chance.one_in(2))) continue;
        const std::string value = value_of(key, chance);
        if (!value.empty()) text += std::string(key.key) + " = " + value + "\n";
    }
    return text;
}

}  // namespace

std::string extreme_scene(std::uint32_t seed) {
    Chance chance{std::mt19937(seed)};
    std::string text;
    for (const char* const table : {"image", "camera", "shading", "ambient", "shadow", "fog", "environment"}) {
        const bool is_needed = std::string_view(table) == "image";
        if (is_needed || chance.one_in(2)) text += table_text(table, chance);
    }
    const int lights = 1 + chance.below(2), objects = 1 + chance.below(2);
    for (int i = 0; i < lights; ++i) text += table_text("light", chance);
    text += table_text("material", chance);
    for (int i = 0; i < objects; ++i) text += table_text("object", chance);
    return text;
}

}  // namespace kreda::tests
