// PNG, the format that every picture is written in, by libpng directly: opening OpenImageIO takes longer than drawing.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace kreda::scene {

/// Rows from the top, the channels of a pixel side by side, encoded as sRGB.
struct PngPicture {
    int width = 0;
    int height = 0;
    int channels = 0;  ///< 1 (grey) or 3
    std::span<const std::uint8_t> values;
};

/// The bytes of an 8-bit PNG, marked sRGB; the same picture gives the same bytes, whatever threads there are. `path` is
/// for the complaint. Throws UserError, std::bad_alloc.
[[nodiscard]] std::vector<unsigned char> encode_png(const std::string& path, const PngPicture& picture);

}  // namespace kreda::scene
