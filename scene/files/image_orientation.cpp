#include "scene/files/image_orientation.hpp"

#include <cstdint>

namespace kreda::scene {

namespace {

/// Numbers of a TIFF structure; what lies outside of it is 0.
struct TiffReader {
    std::string_view bytes;
    bool is_little = true;

    [[nodiscard]] std::uint32_t number(std::size_t offset, std::size_t size) const {
        if (offset > bytes.size() || size > bytes.size() - offset) return 0;
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t at = is_little ? offset + size - 1 - i : offset + i;
            value = value << 8 | static_cast<unsigned char>(bytes[at]);
        }
        return value;
    }
};

}  // namespace

raster::Image upright(raster::Image stored, int orientation) {
    if (orientation < 2 || orientation > 8) return stored;
    const bool rows_are_columns = orientation >= 5;
    const bool from_last_row = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    const bool from_last_column = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    raster::Image image = rows_are_columns ? raster::make_image(stored.height, stored.width, stored.channels)
                                           : raster::make_image(stored.width, stored.height, stored.channels);
    for (int c = 0; c < image.channels; ++c) {
        float* pixel = image.plane(c);
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x, ++pixel) {
                const int row = rows_are_columns ? x : y;
                const int column = rows_are_columns ? y : x;
                *pixel = stored.at(c, from_last_column ? stored.width - 1 - column : column,
                                   from_last_row ? stored.height - 1 - row : row);
            }
        }
    }
    return image;
}

int exif_orientation(std::string_view exif) {
    if (exif.starts_with(std::string_view("Exif\0\0", 6))) exif.remove_prefix(6);
    const bool is_little = exif.starts_with("II");
    if (!is_little && !exif.starts_with("MM")) return 1;
    const TiffReader tiff{exif, is_little};
    constexpr std::uint32_t kOrientation = 274, kShort = 3;
    constexpr std::size_t kEntryBytes = 12;
    const std::size_t directory = tiff.number(4, 4);
    const std::size_t entries = tiff.number(directory, 2);
    for (std::size_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + i * kEntryBytes;
        if (tiff.number(entry, 2) != kOrientation || tiff.number(entry + 2, 2) != kShort) continue;
        const int orientation = static_cast<int>(tiff.number(entry + 8, 2));
        return orientation >= 1 && orientation <= 8 ? orientation : 1;
    }
    return 1;
}

}  // namespace kreda::scene
