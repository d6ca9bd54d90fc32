// Image files, checked: sizes are bounded before anything is allocated, files appear whole or not at all. OpenImageIO
// reads them and writes EXR; it is loaded when the first is needed (scene/files/image_module.hpp). libpng writes PNG.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "raster/image.hpp"

namespace kreda::scene {

/// A header may promise any size: what is larger than this is refused before memory is asked for.
struct ImageReadOptions {
    int max_side = 32768;
    std::int64_t max_values = std::int64_t(1) << 28;  ///< width x height x channels
};

/// Read any image OpenImageIO knows (PNG, EXR, HDR, JPEG, TGA, ...): the values as stored, integers scaled to 0..1,
/// colour not multiplied by alpha, all channels. NaN and infinity stay: ask count_non_finite(). An EXR whose data
/// window is not its display window gives the display window, 0 where there is no data. Throws UserError.
[[nodiscard]] raster::Image read_image(const std::string& path, const ImageReadOptions& options = {});

/// An image and how its file holds a channel.
struct StoredImage {
    raster::Image image;
    int bits = 0;  ///< 8 or 16 for integers; 0 for floating-point numbers, and for longer integers
};

/// The same with the depth of the file.
[[nodiscard]] StoredImage read_stored_image(const std::string& path, const ImageReadOptions& options = {});

/// The byte that a PNG holds for an encoded value: round(255 c), c clamped to 0..1, NaN to 0.
[[nodiscard]] std::uint8_t byte_from_encoded(float encoded);

/// Write 8-bit PNG, marked sRGB, from values that are encoded already: byte = round(255 c), c clamped to 0..1, NaN to
/// 0. 1 (grey) or 3 channels. The same image gives the same bytes. Throws UserError and leaves no partial file.
void write_png(const std::string& path, const raster::Image& encoded);

/// Write float32 EXR from linear values. One name a channel. The same image gives the same bytes. Throws UserError.
void write_exr(const std::string& path, const raster::Image& linear,
               const std::vector<std::string>& channel_names = {"R", "G", "B"});

}  // namespace kreda::scene
