// Images opened with OpenImageIO, their headers read and nothing of their size allocated yet. Part of the module
// kreda_images.
#pragma once

#include <memory>
#include <string>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "scene/files/radiance_header.hpp"

namespace kreda::scene {

/// A file that OpenImageIO reads, or a copy of it in memory.
struct OpenedImage {
    std::string bytes;
    std::unique_ptr<OIIO::Filesystem::IOMemReader> memory;
    std::unique_ptr<OIIO::ImageInput> input;
    int webp_orientation = 0;  ///< 0: not a WebP file
    RadianceHeader radiance;   ///< orientation 0: not a Radiance file
};

/// What the library says of its failure as one sentence: each of its first lines once, without the emptiest.
[[nodiscard]] std::string reason_of(const std::string& text, const std::string& otherwise);

/// Any file that OpenImageIO knows. Throws UserError.
[[nodiscard]] OpenedImage open_image(const std::string& path);

/// A file within another file: PNG, JPEG or WebP. `name` stands for it in messages, `bytes` is the file.
[[nodiscard]] OpenedImage open_image_in_memory(const std::string& name, const std::string& bytes);

}  // namespace kreda::scene
