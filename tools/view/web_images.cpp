// Image files for the module in the browser: what image_module.cpp does with OpenImageIO, done with stb_image. It knows
// PNG, JPEG, TGA, BMP and Radiance, and neither a PNG's gAMA nor colour profiles: integers are taken as sRGB.
#include <filesystem>
#include <fstream>
#include <memory>

#include <stb/stb_image.h>

#include "scene/error.hpp"
#include "scene/files/file_content.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/radiance_header.hpp"

namespace kreda::scene {

namespace {

namespace fs = std::filesystem;

/// Pixels as stb_image gives them: rows from the top, the channels of a pixel side by side.
template <class Value>
using StbPixels = std::unique_ptr<Value[], void (*)(void*)>;

struct ImageBytes {
    std::string bytes;
    [[nodiscard]] const stbi_uc* data() const {
        return reinterpret_cast<const stbi_uc*>(bytes.data());
    }
    [[nodiscard]] int size() const {
        return static_cast<int>(bytes.size());
    }
};

ImageBytes read_bytes(const std::string& path) {
    std::error_code failed;
    if (!fs::exists(path, failed)) throw UserError(Place{path}, "no such image file");
    if (!fs::is_regular_file(path, failed)) throw UserError(Place{path}, "is not a file; an image file is needed");
    constexpr std::uintmax_t kMostBytes = std::uintmax_t(1) << 30;
    const std::uintmax_t size = fs::file_size(path, failed);
    if (size == 0) throw UserError(Place{path}, "is empty; an image file is needed");
    if (size > kMostBytes) throw UserError(Place{path}, "is larger than 1 GiB");
    ImageBytes file{std::string(static_cast<std::size_t>(size), '\0')};
    std::ifstream(path, std::ios::binary).read(file.bytes.data(), static_cast<std::streamsize>(size));
    return file;
}

struct Size {
    int width = 0, height = 0, channels = 0;
};

Size checked_size(const std::string& path, const ImageBytes& file, const ImageReadOptions& options) {
    Size size;
    if (!stbi_info_from_memory(file.data(), file.size(), &size.width, &size.height, &size.channels)) {
        throw UserError(Place{path},
                        "cannot be read as an image: in the browser PNG, JPEG, TGA, BMP and .hdr are known");
    }
    const std::int64_t values = std::int64_t(size.width) * size.height * size.channels;
    if (size.width > options.max_side || size.height > options.max_side || values > options.max_values) {
        throw UserError(Place{path}, "its size, " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                                         " pixels, is not within the limits: 1 to " + std::to_string(options.max_side) +
                                         " a side, at most " + std::to_string(options.max_values) + " values");
    }
    return size;
}

template <class Value>
void keep_planes(const std::string& path, Value* decoded, const Size& size, float unit, StoredImage& stored) {
    const StbPixels<Value> pixels(decoded, stbi_image_free);
    if (!pixels) throw UserError(Place{path}, std::string("is damaged: ") + stbi_failure_reason());
    stored.image = raster::make_image(size.width, size.height, size.channels);
    const std::size_t count = stored.image.plane_size();
    const std::size_t channels = static_cast<std::size_t>(size.channels);
    for (std::size_t c = 0; c < channels; ++c) {
        for (std::size_t i = 0; i < count; ++i) {
            stored.image.values[c * count + i] = static_cast<float>(pixels[i * channels + c]) / unit;
        }
    }
}

void read_radiance(const std::string& path, const ImageBytes& file, StoredImage& stored) {
    const RadianceHeader header = read_radiance_header(file.bytes);
    Size size{0, 0, 3};
    int in_file = 0;
    float* const decoded = stbi_loadf_from_memory(file.data(), file.size(), &size.width, &size.height, &in_file, 3);
    keep_planes(path, decoded, size, 1.0f, stored);
    stored.remarks = header.remarks;
    stored.channels = {"R", "G", "B"};
    for (int c = 0; c < 3; ++c) {
        const float multiplier = header.multiplier[static_cast<std::size_t>(c)];
        float* const plane = stored.image.plane(c);
        for (std::size_t i = 0; i < stored.image.plane_size(); ++i) plane[i] /= multiplier;
    }
}

void read_integers(const std::string& path, const ImageBytes& file, Size size, StoredImage& stored) {
    stored.encoding = Encoding::srgb;
    int in_file = 0;
    if (stbi_is_16_bit_from_memory(file.data(), file.size())) {
        stored.bits = 16;
        keep_planes(
            path,
            stbi_load_16_from_memory(file.data(), file.size(), &size.width, &size.height, &in_file, size.channels),
            size, 65535.0f, stored);
    } else {
        stored.bits = 8;
        keep_planes(path,
                    stbi_load_from_memory(file.data(), file.size(), &size.width, &size.height, &in_file, size.channels),
                    size, 255.0f, stored);
    }
    const bool is_grey = size.channels < 3;
    stored.channels = is_grey ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"};
    if (size.channels % 2 != 0) return;
    stored.alpha = size.channels - 1;
    stored.channels.emplace_back("A");
}

}  // namespace

StoredImage read_stored_bytes(const std::string& path, const std::string& bytes, const ImageReadOptions& options) {
    const ImageBytes file{bytes};
    const std::string other = other_content(file.bytes);
    if (!other.empty()) throw UserError(Place{path}, other);
    const Size size = checked_size(path, file, options);
    StoredImage stored;
    if (stbi_is_hdr_from_memory(file.data(), file.size()))
        read_radiance(path, file, stored);
    else
        read_integers(path, file, size, stored);
    return stored;
}

StoredImage read_stored_image(const std::string& path, const ImageReadOptions& options) {
    return read_stored_bytes(path, read_bytes(path).bytes, options);
}

raster::Image read_image(const std::string& path, const ImageReadOptions& options) {
    return read_stored_image(path, options).image;
}

}  // namespace kreda::scene
