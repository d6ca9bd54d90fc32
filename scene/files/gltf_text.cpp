#include "scene/files/gltf_text.hpp"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

#include "scene/files/file_content.hpp"
#include "scene/files/obj_text.hpp"

namespace kreda::scene {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxDepth = 100;  // real files have about ten

std::string read_file(const std::string& path) {
    std::string bytes(size_of_mesh_file(path), '\0');
    std::ifstream stream(path, std::ios::binary);
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!stream) throw UserError(Place{path}, "cannot be read; check its permissions");
    return bytes;
}

std::uint32_t little_endian(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

/// The first chunk of a .glb.            glTF 2.0 specification, section 4.4
std::string json_chunk(const std::string& path, const std::string& bytes) {
    constexpr std::size_t kHeader = 12, kChunkHeader = 8;
    constexpr std::uint32_t kJson = 0x4e4f534a;
    if (bytes.size() < kHeader + kChunkHeader) throw UserError(Place{path}, "is cut off: it ends in its header");
    const std::uint32_t version = little_endian(bytes, 4), length = little_endian(bytes, 8);
    if (version != 2) {
        throw UserError(Place{path}, "is glTF of version " + std::to_string(version) + "; version 2 is read");
    }
    if (length > bytes.size()) {
        throw UserError(Place{path}, "is cut off: it has " + std::to_string(bytes.size()) + " of its " +
                                         std::to_string(length) + " bytes; download it again");
    }
    const std::size_t size = little_endian(bytes, kHeader);
    if (little_endian(bytes, kHeader + 4) != kJson) throw UserError(Place{path}, "is damaged: it begins with no JSON");
    if (size > length - std::min<std::size_t>(length, kHeader + kChunkHeader)) {
        throw UserError(Place{path}, "is damaged: its JSON would be longer than the file");
    }
    return bytes.substr(kHeader + kChunkHeader, size);
}

/// Walks over a JSON text, whether it is well-formed or not, and notes where the objects of the root's arrays begin.
struct PlaceScan {
    GltfText& text;
    std::vector<char> open = {};  ///< the brackets around the place
    std::string key = {};         ///< the last string directly inside of the root
    std::size_t count = 0;        ///< objects of the array so far

    void run() {
        const std::string& json = text.json.text;
        for (std::size_t at = 0; at < json.size(); ++at) {
            const char c = json[at];
            if (c == '"') {
                at = end_of_string(at);
            } else if (c == '{' || c == '[') {
                enter(c, at);
            } else if ((c == '}' || c == ']') && !open.empty()) {
                open.pop_back();
            }
        }
    }

    void enter(char bracket, std::size_t at) {
        if (open.size() == 1) count = 0;
        if (bracket == '{' && open.size() == 2 && open[1] == '[') text.offset_of[{key, count++}] = at;
        open.push_back(bracket);
        if (open.size() <= kMaxDepth) return;
        throw UserError(text.is_binary ? Place{text.json.file} : place_at(text.json, at),
                        "is nested more than " + std::to_string(kMaxDepth) + " brackets deep; no glTF needs that");
    }

    std::size_t end_of_string(std::size_t begin) {
        const std::string& json = text.json.text;
        std::size_t at = begin + 1;
        while (at < json.size() && json[at] != '"') at += json[at] == '\\' ? 2 : 1;
        if (open.size() == 1) key = json.substr(begin + 1, std::min(at, json.size()) - begin - 1);
        return at;
    }
};

}  // namespace

bool is_gltf_name(const std::string& path) {
    const std::string extension = in_lower_case(fs::path(path).extension().string());
    return extension == ".gltf" || extension == ".glb";
}

GltfText read_gltf_text(const std::string& path) {
    GltfText text;
    text.bytes = read_file(path);
    text.is_binary = text.bytes.starts_with("glTF");
    text.json.file = path;
    if (text.is_binary) {
        text.json.text = json_chunk(path, text.bytes);
    } else {
        if (const std::string other = other_content(text.bytes); !other.empty()) throw UserError(Place{path}, other);
        if (text.bytes.starts_with("\xef\xbb\xbf")) text.bytes.erase(0, 3);
        const std::size_t first = text.bytes.find_first_not_of(" \t\r\n");
        if (first == std::string::npos) throw UserError(Place{path}, "is empty; a glTF file is needed");
        if (text.bytes[first] != '{') {
            throw UserError(place_at({path, text.bytes}, first), "is neither JSON (.gltf) nor a binary glTF (.glb)");
        }
        text.json.text = text.bytes;
    }
    PlaceScan{text}.run();
    return text;
}

Place place_of(const GltfText& text, const std::string& list, std::size_t index) {
    const auto found = text.offset_of.find({list, index});
    if (text.is_binary || found == text.offset_of.end()) return Place{text.json.file};
    return place_at(text.json, found->second);
}

UserError gltf_error(const GltfText& text, const std::string& list, std::size_t index, const std::string& message) {
    return {place_of(text, list, index), list + "[" + std::to_string(index) + "]: " + message};
}

}  // namespace kreda::scene
