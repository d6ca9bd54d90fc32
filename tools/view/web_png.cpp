// PNG files of the module: stb_image_write in place of libpng.
#include <string>
#include <vector>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

#include "raster/film.hpp"
#include "scene/error.hpp"
#include "scene/files/image_file.hpp"

namespace kreda::scene {

std::vector<unsigned char> png_file_of(const std::string& path, const raster::Image& encoded) {
    const std::size_t count = encoded.plane_size(), channels = static_cast<std::size_t>(encoded.channels);
    std::vector<std::uint8_t> bytes(count * channels);
    for (std::size_t c = 0; c < channels; ++c) {
        const float* const plane = encoded.plane(static_cast<int>(c));
        for (std::size_t i = 0; i < count; ++i) bytes[i * channels + c] = byte_from_encoded(plane[i]);
    }
    std::vector<unsigned char> file;
    const auto keep = [](void* context, void* data, int size) {
        auto& all = *static_cast<std::vector<unsigned char>*>(context);
        const auto* first = static_cast<unsigned char*>(data);
        all.insert(all.end(), first, first + size);
    };
    if (!stbi_write_png_to_func(keep, &file, encoded.width, encoded.height, encoded.channels, bytes.data(), 0)) {
        throw UserError(Place{path}, "cannot be written as PNG");
    }
    return file;
}

}  // namespace kreda::scene
