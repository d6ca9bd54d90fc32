// A glTF file as it lies on the disk: its bytes, its JSON text, and where in the text things stand.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "scene/error.hpp"
#include "scene/files/obj_text.hpp"

namespace kreda::scene {

/// A .gltf is the JSON text itself; a .glb has it as its first chunk, and the first buffer's bytes as its second.
struct GltfText {
    std::string bytes;                                                     ///< of the whole file
    bool is_binary = false;                                                ///< a .glb
    ObjText json;                                                          ///< under the file's name
    std::map<std::pair<std::string, std::size_t>, std::size_t> offset_of;  ///< ("accessors", 3) -> byte in json.text
};

/// Is this the name of a glTF file?
[[nodiscard]] bool is_gltf_name(const std::string& path);

/// Read a file and find its JSON. Refuses what is no file, is above 1 GB, cut off, no glTF 2, or nested so deep that a
/// reader would run out of stack. Throws UserError.
[[nodiscard]] GltfText read_gltf_text(const std::string& path);

/// Line and column of the thing that stands at `index` of the array `list`; of a .glb, whose JSON has no lines, the
/// file alone.
[[nodiscard]] Place place_of(const GltfText& text, const std::string& list, std::size_t index);

/// "FILE:LINE:COL: accessors[3]: message", as UserError takes it.
[[nodiscard]] UserError gltf_error(const GltfText& text, const std::string& list, std::size_t index,
                                   const std::string& message);

}  // namespace kreda::scene
