// glTF 2.0 through tinygltf: the JSON as structures, and the bytes of the buffers. Nothing of it is checked yet.
#pragma once

#include <memory>
#include <string>

#include <tiny_gltf.h>

#include "scene/files/gltf_text.hpp"
#include "scene/files/named_file.hpp"

namespace kreda::scene {

/// A file and what the library made of it. Images that are data URIs hold the file's bytes in Image::image.
struct GltfFile {
    GltfText text;
    NamedFileLimits limits;
    tinygltf::Model model;
};

/// Read a file with its buffers, which must lie in its folder unless limits.allow_outside. Images are not read. Throws
/// UserError.
[[nodiscard]] GltfFile read_gltf_file(const std::string& path, const NamedFileLimits& limits);

/// A path as it stands in an URI: "My%20Texture.png" -> "My Texture.png".
[[nodiscard]] std::string path_of_uri(const std::string& uri);

/// Is there an element of that number?
template <class Element>
[[nodiscard]] bool has_element(const std::vector<Element>& elements, int index) {
    return index >= 0 && static_cast<std::size_t>(index) < elements.size();
}

}  // namespace kreda::scene
