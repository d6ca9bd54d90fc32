// The only file that includes OpenImageIO: its headers take seconds to compile, and its libraries longer to load than
// most pictures to draw. It is a module, which scene/files/image_module.cpp opens when it is needed.
#include "scene/files/image_file.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "scene/error.hpp"
#include "scene/files/image_module.hpp"

namespace kreda::scene {

namespace {

namespace fs = std::filesystem;

/// The bytes of the file.
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

std::vector<unsigned char> encode_exr(const std::string& path, const InterleavedImage& image) {
    const int channels = static_cast<int>(image.channel_names.size());
    OIIO::ImageSpec spec(image.width, image.height, channels, OIIO::TypeFloat);
    spec.channelnames = image.channel_names;
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", "1970:01:01 00:00:00");  // otherwise the time of writing, and no two files are equal
    spec.attribute("oiio:ColorSpace", "Linear");
    return encode(path, "openexr", spec, OIIO::TypeFloat, image.values.data());
}

}  // namespace kreda::scene

/// The only name that the module shows.
extern "C" __attribute__((visibility("default"))) const kreda::scene::ImageModule* kreda_image_module() {
    static const kreda::scene::ImageModule module{.read_stored_image = kreda::scene::read_stored_image,
                                                  .encode_exr = kreda::scene::encode_exr};
    return &module;
}
