// The only file that includes OpenImageIO: its headers take seconds to compile.
#include "scene/files/image_file.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <memory>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/hash.h>
#include <OpenImageIO/imageio.h>

#include "scene/error.hpp"
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

/// The bytes of the file. They are made in memory because the library's PNG writer does not notice a full disk.
std::vector<unsigned char> encode(const std::string& path, const std::string& format, const OIIO::ImageSpec& spec,
                                  OIIO::TypeDesc type, const void* interleaved) {
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
    if (!output) throw UserError(Place{path}, "cannot be written: " + OIIO::geterror());
    OIIO::Filesystem::IOVecOutput memory;
    const bool is_encoded = output->set_ioproxy(&memory) && output->open(path, spec) &&
                            output->write_image(type, interleaved) && output->close();
    if (!is_encoded) throw UserError(Place{path}, "cannot be written: " + output->geterror());
    return memory.buffer();
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

std::string size_text(const OIIO::ImageSpec& spec) {
    return std::to_string(spec.full_width) + " x " + std::to_string(spec.full_height) + " pixels, " +
           std::to_string(spec.nchannels) + " channels";
}

/// The header alone: nothing of its size has been allocated yet.
void check_size(const std::string& path, const OIIO::ImageSpec& spec, const ImageReadOptions& options) {
    constexpr int kMaxChannels = 1024;
    const auto refuse = [&](int width, int height) {
        if (width < 1 || height < 1 || spec.nchannels < 1) return true;
        if (width > options.max_side || height > options.max_side || spec.nchannels > kMaxChannels) return true;
        return std::int64_t(width) * height * spec.nchannels > options.max_values;
    };
    if (refuse(spec.width, spec.height) || refuse(spec.full_width, spec.full_height)) {
        throw UserError(Place{path}, "its size, " + size_text(spec) + ", is not within the limits: 1 to " +
                                         std::to_string(options.max_side) + " a side, at most " +
                                         std::to_string(options.max_values) + " values");
    }
    if (spec.depth > 1 || spec.deep) throw UserError(Place{path}, "is a volume or a deep image; a flat one is needed");
}

/// The data window, interleaved, becomes the display window, planar.
raster::Image display_window(const OIIO::ImageSpec& spec, const std::vector<float>& data) {
    raster::Image image = raster::make_image(spec.full_width, spec.full_height, spec.nchannels);
    const std::int64_t left = std::int64_t(spec.x) - spec.full_x;
    const std::int64_t top = std::int64_t(spec.y) - spec.full_y;
    const std::int64_t first_row = std::max<std::int64_t>(0, -top);
    const std::int64_t end_row = std::min<std::int64_t>(spec.height, spec.full_height - top);
    const std::int64_t first_column = std::max<std::int64_t>(0, -left);
    const std::int64_t end_column = std::min<std::int64_t>(spec.width, spec.full_width - left);
    for (int c = 0; c < spec.nchannels; ++c) {
        for (std::int64_t row = first_row; row < end_row; ++row) {
            const float* source = data.data() + row * spec.width * spec.nchannels + c;
            float* target = image.plane(c) + (row + top) * spec.full_width;
            for (std::int64_t column = first_column; column < end_column; ++column) {
                target[column + left] = source[column * spec.nchannels];
            }
        }
    }
    return image;
}

void check_is_file(const std::string& path) {
    if (!fs::exists(path)) throw UserError(Place{path}, "no such image file");
    if (!fs::is_regular_file(path)) throw UserError(Place{path}, "is not a file; an image file is needed");
}

std::unique_ptr<OIIO::ImageInput> open_input(const std::string& path) {
    OIIO::ImageSpec wish;
    wish.attribute("oiio:UnassociatedAlpha", 1);  // otherwise PNG's colours come multiplied by alpha
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path, &wish);
    if (!input) throw UserError(Place{path}, "cannot be read as an image: " + OIIO::geterror());
    return input;
}

/// 8 or 16; 0 where a channel is no short integer.
int bits_of(const OIIO::ImageSpec& spec) {
    if (spec.format.is_floating_point() || spec.format.size() > 2) return 0;
    return static_cast<int>(8 * spec.format.size());
}

StoredImage read_with_oiio(const std::string& path, const ImageReadOptions& options) {
    const std::unique_ptr<OIIO::ImageInput> input = open_input(path);
    const OIIO::ImageSpec spec = input->spec();
    check_size(path, spec, options);
    std::vector<float> data(static_cast<std::size_t>(std::int64_t(spec.width) * spec.height * spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, data.data())) {
        throw UserError(Place{path}, "is damaged: " + input->geterror());
    }
    return {display_window(spec, data), bits_of(spec)};
}

}  // namespace

std::uint8_t byte_from_encoded(float encoded) {
    if (!(encoded > 0.0f)) return 0;  // true for NaN as well
    return static_cast<std::uint8_t>(std::lround(255.0f * std::min(encoded, 1.0f)));
}

std::uint64_t hash_of_bytes(std::span<const std::byte> bytes, std::uint64_t seed) {
    return OIIO::xxhash::XXH64(bytes.data(), bytes.size(), seed);
}

raster::Image read_image(const std::string& path, const ImageReadOptions& options) {
    return read_stored_image(path, options).image;
}

StoredImage read_stored_image(const std::string& path, const ImageReadOptions& options) {
    check_is_file(path);
    try {
        return read_with_oiio(path, options);
    } catch (const UserError&) {
        throw;
    } catch (const std::exception& damage) {  // the library's own, on headers that make no sense
        throw UserError(Place{path}, std::string("is damaged: ") + damage.what());
    }
}

void write_png(const std::string& path, const raster::Image& encoded) {
    check_output_path(path, ".png");
    check_not_empty(path, encoded);
    KREDA_EXPECT(encoded.channels == 1 || encoded.channels == 3);
    OIIO::ImageSpec spec(encoded.width, encoded.height, encoded.channels, OIIO::TypeUInt8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    const auto bytes = interleave<std::uint8_t>(encoded, byte_from_encoded);
    const std::vector<unsigned char> file = encode(path, "png", spec, OIIO::TypeUInt8, bytes.data());
    write_whole_file(path, {std::as_bytes(std::span(file))});
}

void write_exr(const std::string& path, const raster::Image& linear, const std::vector<std::string>& channel_names) {
    check_output_path(path, ".exr");
    check_not_empty(path, linear);
    KREDA_EXPECT(static_cast<std::size_t>(linear.channels) == channel_names.size());
    OIIO::ImageSpec spec(linear.width, linear.height, linear.channels, OIIO::TypeFloat);
    spec.channelnames = channel_names;
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", "1970:01:01 00:00:00");  // otherwise the time of writing, and no two files are equal
    spec.attribute("oiio:ColorSpace", "Linear");
    const auto values = interleave<float>(linear, [](float value) { return value; });
    const std::vector<unsigned char> file = encode(path, "openexr", spec, OIIO::TypeFloat, values.data());
    write_whole_file(path, {std::as_bytes(std::span(file))});
}

}  // namespace kreda::scene
