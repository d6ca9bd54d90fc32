// Image files, checked: sizes are bounded before anything is allocated, files appear whole or not at all. OpenImageIO
// reads them and writes EXR; it is loaded when the first is needed (scene/files/image_module.hpp). libpng writes PNG.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "raster/image.hpp"
#include "scene/files/png_bytes.hpp"

namespace kreda::scene {

/// A header may promise any size: what is larger than this is refused before memory is asked for. A file may also keep
/// its decoder busy for other reasons, or crash it: it runs in a child process, which may use this.
struct ImageReadOptions {
    int max_side = 32768;
    std::int64_t max_values = std::int64_t(1) << 28;    ///< width x height x channels
    std::int64_t spare_memory = std::int64_t(1) << 30;  ///< bytes, beyond what a picture of its size needs
    int spare_seconds = 10;                             ///< of processor time, beyond what its size explains
};

/// How light became the numbers of a file.
enum class Encoding { linear, srgb, power };

/// An image as its file holds it, upright, and what the numbers are.
struct StoredImage {
    raster::Image image;
    int bits = 0;  ///< 8 or 16 for integers; 0 for floating-point numbers, and for longer integers
    Encoding encoding = Encoding::linear;  ///< of colours: floats are linear, integers sRGB unless the file says else
    float gamma = 1.0f;                    ///< for power: linear = stored^gamma
    bool is_divided = false;               ///< colours were multiplied by alpha in the file: they are no integers now
    int alpha = -1;                        ///< the channel of opacity, or -1
    std::string unknown_space;             ///< a name of colours that is not known here, or ""
    std::vector<std::string> channels;     ///< their names
    std::vector<std::string> remarks;  ///< what was done, for people: "is stored as '+Y 32 +X 64'; it was set upright"

    /// How many values a channel can have; 0: it is no short integer.
    [[nodiscard]] int levels() const {
        return bits > 0 && !is_divided ? 1 << bits : 0;
    }
};

/// Read any image OpenImageIO knows (PNG, EXR, HDR, JPEG, TGA, ...): the values as stored, integers scaled to 0..1,
/// all channels (but WebP's alpha). Set upright as the file demands; colours not multiplied by alpha, nor by Radiance's
/// EXPOSURE and COLORCORR. NaN and infinity stay: ask count_non_finite(). An EXR whose data window is not its display
/// window gives the display window, 0 where there is no data. Throws UserError.
[[nodiscard]] StoredImage read_stored_image(const std::string& path, const ImageReadOptions& options = {});

/// The same of a PNG, JPEG or WebP file whose bytes are in memory, part of another file. `name` stands for it in
/// messages.
[[nodiscard]] StoredImage read_stored_bytes(const std::string& name, const std::string& bytes,
                                            const ImageReadOptions& options = {});

/// The values alone.
[[nodiscard]] raster::Image read_image(const std::string& path, const ImageReadOptions& options = {});

/// The byte that a PNG holds for an encoded value: round(255 c), c clamped to 0..1, NaN to 0.
[[nodiscard]] inline std::uint8_t byte_from_encoded(float encoded) {
    if (!(encoded > 0.0f)) return 0;  // true for NaN as well
    const float scaled = 255.0f * std::min(encoded, 1.0f);
    const int whole = static_cast<int>(scaled);
    return static_cast<std::uint8_t>(whole + (scaled - static_cast<float>(whole) >= 0.5f ? 1 : 0));
}

/// The bytes of the file that write_png writes; `path` is named in errors.
[[nodiscard]] std::vector<unsigned char> png_file_of(const std::string& path, const raster::Image& encoded);

/// Write 8-bit PNG, marked sRGB, from values that are encoded already: byte = round(255 c), c clamped to 0..1, NaN to
/// 0. 1 (grey) or 3 channels. The same image gives the same bytes. Throws UserError and leaves no partial file.
void write_png(const std::string& path, const raster::Image& encoded);
/// The same of a picture whose bytes are there already.
void write_png(const std::string& path, const PngPicture& picture);

/// Write float32 EXR from linear values. One name a channel. The same image gives the same bytes. Throws UserError.
void write_exr(const std::string& path, const raster::Image& linear,
               const std::vector<std::string>& channel_names = {"R", "G", "B"});

}  // namespace kreda::scene
