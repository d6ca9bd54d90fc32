// The one part of the program that needs OpenImageIO, as a shared library that is opened when an image file is read or
// an EXR written: OpenImageIO brings some 200 libraries, and loading them takes longer than drawing most pictures.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/files/image_file.hpp"

namespace kreda::scene {

/// Linear values as an EXR takes them: rows from the top, the channels of a pixel side by side.
struct InterleavedImage {
    int width = 0;
    int height = 0;
    std::vector<std::string> channel_names;
    std::vector<float> values;
};

/// What the module offers: functions of scene/files/image_file.cpp. They throw UserError.
struct ImageModule {
    std::size_t options_size = sizeof(ImageReadOptions);  ///< as the module was compiled; another program's differ
    std::size_t image_size = sizeof(StoredImage);
    StoredImage (*read_stored_image)(const std::string& path, const ImageReadOptions& options) = nullptr;
    StoredImage (*read_stored_bytes)(const std::string& name, const std::string& bytes,
                                     const ImageReadOptions& options) = nullptr;
    std::vector<unsigned char> (*encode_exr)(const std::string& path, const InterleavedImage& image) = nullptr;
};

/// Where the module may be: beside the running program, in ../lib/kreda from there (so `cmake --install` and the build
/// leave it), along the program's run path (so find_package(kreda) leaves it: a name without a folder), and in the
/// folder of the build, for programs that were copied elsewhere.
[[nodiscard]] std::vector<std::string> image_module_places();

/// Open the first of these files that exists. It stays open to the end of the program. Throws UserError at `image`
/// when there is none, when it (or OpenImageIO) cannot be loaded, and when it belongs to another build.
[[nodiscard]] const ImageModule& open_image_module(const std::vector<std::string>& places, const std::string& image);

/// The bytes of an EXR file, by the module; the same image gives the same bytes. Throws UserError.
[[nodiscard]] std::vector<unsigned char> encode_exr(const std::string& path, const InterleavedImage& image);

}  // namespace kreda::scene
