// The half of image_file.hpp that writes.
#include <cctype>
#include <filesystem>

#include "scene/error.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/image_module.hpp"
#include "scene/files/png_bytes.hpp"
#include "scene/files/whole_file.hpp"

namespace kreda::scene {

namespace {

namespace fs = std::filesystem;

std::string lower_case_extension(const std::string& path) {
    std::string extension = fs::path(path).extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

void check_output_path(const std::string& path, const std::string& extension) {
    if (lower_case_extension(path) != extension) {
        throw UserError(Place{path}, "this picture is written as " + extension +
                                         "; pictures are .png (8-bit sRGB) or .exr (linear float)");
    }
    const fs::path folder = fs::path(path).parent_path();
    if (!folder.empty() && !fs::is_directory(folder)) {
        throw UserError(Place{path}, "the folder " + folder.string() + " does not exist; create it first");
    }
    if (fs::is_directory(path)) throw UserError(Place{path}, "is a folder; a picture needs a file name");
}

template <typename Value, typename Convert>
std::vector<Value> interleave(const raster::Image& image, Convert convert) {
    std::vector<Value> values(image.values.size());
    const std::size_t pixels = image.plane_size();
    const std::size_t channels = static_cast<std::size_t>(image.channels);
    for (std::size_t c = 0; c < channels; ++c) {
        for (std::size_t i = 0; i < pixels; ++i) values[i * channels + c] = convert(image.values[c * pixels + i]);
    }
    return values;
}

void check_not_empty(const std::string& path, const raster::Image& image) {
    if (image.width < 1 || image.height < 1 || image.channels < 1) {
        throw UserError(Place{path}, "an image of " + std::to_string(image.width) + " x " +
                                         std::to_string(image.height) + " pixels cannot be written");
    }
    KREDA_EXPECT(image.values.size() == image.plane_size() * static_cast<std::size_t>(image.channels));
}

}  // namespace

std::vector<unsigned char> png_file_of(const std::string& path, const raster::Image& encoded) {
    check_not_empty(path, encoded);
    KREDA_EXPECT(encoded.channels == 1 || encoded.channels == 3);
    const auto bytes = interleave<std::uint8_t>(encoded, byte_from_encoded);
    return encode_png(path, {encoded.width, encoded.height, encoded.channels, bytes});
}

void write_png(const std::string& path, const raster::Image& encoded) {
    check_output_path(path, ".png");
    const std::vector<unsigned char> file = png_file_of(path, encoded);
    write_whole_file(path, {std::as_bytes(std::span(file))});
}

void write_png(const std::string& path, const PngPicture& picture) {
    check_output_path(path, ".png");
    const std::vector<unsigned char> file = encode_png(path, picture);
    write_whole_file(path, {std::as_bytes(std::span(file))});
}

void write_exr(const std::string& path, const raster::Image& linear, const std::vector<std::string>& channel_names) {
    check_output_path(path, ".exr");
    check_not_empty(path, linear);
    KREDA_EXPECT(static_cast<std::size_t>(linear.channels) == channel_names.size());
    const auto values = interleave<float>(linear, [](float value) { return value; });
    const std::vector<unsigned char> file = encode_exr(path, {linear.width, linear.height, channel_names, values});
    write_whole_file(path, {std::as_bytes(std::span(file))});
}

}  // namespace kreda::scene
