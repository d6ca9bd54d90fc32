// glTF files made by tests: numbers go into one buffer, the rest of the JSON is given as text.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "scene/files/mesh_file.hpp"
#include "tests/scene/mesh_text.hpp"

namespace kreda::tests {

enum GltfType {
    kByte = 5120,
    kUnsignedByte = 5121,
    kShort = 5122,
    kUnsignedShort = 5123,
    kUnsignedInt = 5125,
    kFloat = 5126
};

[[nodiscard]] inline std::string base64_of(const std::string& bytes) {
    static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t j = 0; j < 3; ++j)
            group = group << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0u);
        for (std::size_t j = 0; j < 4; ++j) {
            text += i + j <= bytes.size() ? digits[group >> (18 - 6 * j) & 63] : '=';
        }
    }
    return text;
}

struct GltfMaker {
    std::string bin, views, accessors;
    int view_count = 0, accessor_count = 0;

    /// A buffer view on these bytes; returns its number.
    int add_view(const std::string& bytes, int stride = 0) {
        while (bin.size() % 4 != 0) bin += '\0';
        views += (views.empty() ? "" : ",\n") + std::string("{\"buffer\":0,\"byteOffset\":") +
                 std::to_string(bin.size()) + ",\"byteLength\":" + std::to_string(bytes.size()) +
                 (stride > 0 ? ",\"byteStride\":" + std::to_string(stride) : "") + "}";
        bin += bytes;
        return view_count++;
    }

    /// An accessor; view -1: none; `more` begins with a comma.
    int add_accessor(int view, int component, const std::string& type, std::size_t count,
                     const std::string& more = "") {
        accessors += (accessors.empty() ? "" : ",\n") + std::string("{") +
                     (view >= 0 ? "\"bufferView\":" + std::to_string(view) + "," : "") +
                     "\"componentType\":" + std::to_string(component) + ",\"type\":\"" + type +
                     "\",\"count\":" + std::to_string(count) + more + "}";
        return accessor_count++;
    }

    /// The least and the largest of each column of three, which positions must have.
    template <class Number>
    [[nodiscard]] static std::string bounds(const std::vector<Number>& numbers) {
        std::string least, most;
        for (std::size_t column = 0; column < 3; ++column) {
            Number a = numbers.at(column), b = a;
            for (std::size_t i = column; i < numbers.size(); i += 3)
                a = std::min(a, numbers[i]), b = std::max(b, numbers[i]);
            if (!std::isfinite(static_cast<double>(b) - static_cast<double>(a))) return "";
            char text[2][32];
            std::snprintf(text[0], sizeof(text[0]), "%.9g", static_cast<double>(a));
            std::snprintf(text[1], sizeof(text[1]), "%.9g", static_cast<double>(b));
            least += (column > 0 ? "," : "") + std::string(text[0]);
            most += (column > 0 ? "," : "") + std::string(text[1]);
        }
        return ",\"min\":[" + least + "],\"max\":[" + most + "]";
    }

    /// `"extensionsUsed":[...],` of all that the text names.
    [[nodiscard]] static std::string extensions_of(const std::string& text) {
        std::set<std::string> names;
        const std::regex name("\"((KHR|EXT)_\\w+)\"");
        for (std::sregex_iterator found(text.begin(), text.end(), name), end; found != end; ++found)
            names.insert((*found)[1]);
        std::string list;
        for (const std::string& each : names) list += (list.empty() ? "\"" : ",\"") + each + "\"";
        return list.empty() ? "" : "\"extensionsUsed\":[" + list + "],";
    }

    /// Numbers as they lie in memory, `per_element` of them an element.
    template <class Number>
    int add(const std::vector<Number>& numbers, int component, int per_element, const std::string& more = "") {
        const char* const types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
        std::string bytes(numbers.size() * sizeof(Number), '\0');
        std::memcpy(bytes.data(), numbers.data(), bytes.size());
        return add_accessor(add_view(bytes), component, types[per_element - 1],
                            numbers.size() / static_cast<std::size_t>(per_element),
                            more + (per_element == 3 && more.find("\"min\"") == more.npos ? bounds(numbers) : ""));
    }

    [[nodiscard]] std::string json(const std::string& rest, const std::string& uri) const {
        return "{" + extensions_of(rest) + "\"asset\":{\"version\":\"2.0\"},\n\"buffers\":[{" + uri +
               "\"byteLength\":" + std::to_string(bin.size()) + "}],\n\"bufferViews\":[" + views +
               "],\n\"accessors\":[" + accessors + "],\n" + rest + "}";
    }

    /// The text of a .gltf; `rest`: its other keys.
    [[nodiscard]] std::string gltf(const std::string& rest) const {
        return json(rest, "\"uri\":\"data:application/octet-stream;base64," + base64_of(bin) + "\",");
    }

    /// The bytes of a .glb.
    [[nodiscard]] std::string glb(const std::string& rest) const {
        const auto word = [](std::size_t value) {
            std::string bytes;
            for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xff);
            return bytes;
        };
        std::string text = json(rest, ""), binary = bin;
        while (text.size() % 4 != 0) text += ' ';
        while (binary.size() % 4 != 0) binary += '\0';
        return "glTF" + word(2) + word(28 + text.size() + binary.size()) + word(text.size()) + "JSON" + text +
               word(binary.size()) + std::string("BIN\0", 4) + binary;
    }
};

/// One mesh of one primitive in one node: what most tests need. `primitive`: inside of its braces, `node` as well.
[[nodiscard]] inline std::string one_mesh(const std::string& primitive, const std::string& more = "",
                                          const std::string& node = "\"mesh\":0") {
    return "\"scenes\":[{\"nodes\":[0]}],\n\"nodes\":[{" + node + "}],\n\"meshes\":[{\"name\":\"m\",\"primitives\":[{" +
           primitive + "}]}]" + more;
}

/// A corner of the unit square as a triangle:  (0 0 0) (1 0 0) (0 1 0).
inline const std::vector<float> kCorner = {0, 0, 0, 1, 0, 0, 0, 1, 0};
inline const std::string kPosition0 = "\"attributes\":{\"POSITION\":0}";

/// Khronos' validator reads what tests read: with KREDA_KEEP_GLTF, a folder, every file is kept there.
inline void keep_gltf(const std::string& bytes) {
    static int count = 0;
    if (const char* const folder = std::getenv("KREDA_KEEP_GLTF")) {
        const char* const kind = bytes.starts_with("glTF") ? ".glb" : ".gltf";
        std::ofstream(std::string(folder) + "/" + std::to_string(count++) + kind, std::ios::binary) << bytes;
    }
}

/// A file that breaks a rule of the specification which Kreda does not need: as they are found.
[[nodiscard]] inline LoadedText load_loose_gltf(const std::string& bytes, const std::string& name = "a.gltf") {
    const TempFolder folder;
    folder.write(name, bytes);
    return load(folder, name);
}

[[nodiscard]] inline LoadedText load_gltf(const std::string& bytes, const std::string& name = "a.gltf") {
    keep_gltf(bytes);
    return load_loose_gltf(bytes, name);
}

[[nodiscard]] inline std::string error_of_gltf(const std::string& bytes, const std::string& name = "a.gltf") {
    const TempFolder folder;
    return without_folder(folder, error_of_file(folder.write(name, bytes)));
}

}  // namespace kreda::tests
