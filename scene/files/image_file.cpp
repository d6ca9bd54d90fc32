// With open_image.cpp the only file that includes OpenImageIO: its headers take seconds to compile, and its libraries
// longer to load than most pictures to draw. They are a module, which scene/files/image_module.cpp opens when it is
// needed.
#include "scene/files/image_file.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <memory>
#include <new>
#include <stdexcept>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "scene/error.hpp"
#include "scene/files/child_process.hpp"
#include "scene/files/icc_profile.hpp"
#include "scene/files/image_color.hpp"
#include "scene/files/image_module.hpp"
#include "scene/files/image_orientation.hpp"
#include "scene/files/open_image.hpp"
#include "scene/files/quoted_text.hpp"

#if defined(KREDA_COVERAGE)
extern "C" void __gcov_dump();  // of gcc's libgcov
#endif

namespace kreda::scene {

namespace {

#if defined(KREDA_COVERAGE)
/// Writes down which of the module's lines were run, before the child process that ran them ends at once.
struct WriteCounts {
    ~WriteCounts() {
        __gcov_dump();
    }
};
#endif

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

/// While it lives, what C libraries print on stderr is lost: libpng complains there, and we complain again. std::cerr
/// keeps writing.
class QuietLibraries {
public:
    QuietLibraries() {
        if (nowhere_) stderr = nowhere_;
    }
    ~QuietLibraries() {
        stderr = old_;
        if (nowhere_) std::fclose(nowhere_);
    }
    QuietLibraries(const QuietLibraries&) = delete;
    QuietLibraries& operator=(const QuietLibraries&) = delete;

private:
    std::FILE* old_ = stderr;
    std::FILE* nowhere_ = std::fopen("/dev/null", "w");
};

/// The library's exceptions, on headers that make no sense, may name nothing but a function of the C++ library.
std::string reason_of_exception(const std::exception& damage) {
    const bool is_internal =
        dynamic_cast<const std::logic_error*>(&damage) || dynamic_cast<const std::bad_alloc*>(&damage);
    const std::string nonsense = "its header promises what cannot be";
    return is_internal ? nonsense : reason_of(damage.what(), nonsense);
}

/// 8 or 16; 0 where a channel is no short integer.
int bits_of(const OIIO::ImageSpec& spec) {
    if (spec.format.is_floating_point() || spec.format.size() > 2) return 0;
    return static_cast<int>(8 * spec.format.size());
}

std::string_view icc_profile(const OIIO::ImageSpec& spec) {
    const OIIO::ParamValue* const profile = spec.find_attribute("ICCProfile");
    if (!profile || profile->type().basetype != OIIO::TypeDesc::UINT8) return {};
    return {static_cast<const char*>(profile->data()), static_cast<std::size_t>(profile->type().size())};
}

/// Floats are linear. Integers are sRGB unless the file says that they are linear or a power: PNG's gAMA does. 2.2 is
/// how a PNG without an sRGB chunk says sRGB (PNG specification, 11.3.2.5); PNM's
/// Rec709 is taken for it, as all programs do.
void read_encoding(const OIIO::ImageSpec& spec, StoredImage& stored) {
    if (stored.bits == 0) return;
    stored.encoding = Encoding::srgb;
    std::string space(spec.get_string_attribute("oiio:ColorSpace"));
    for (char& c : space) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const float gamma = spec.get_float_attribute("oiio:Gamma", 0.0f);
    if (space == "linear" || std::abs(gamma - 1.0f) < 0.01f) {
        stored.encoding = Encoding::linear;
    } else if (gamma > 0.25f && gamma < 4.0f && std::abs(gamma - 2.2f) > 0.05f) {
        stored.encoding = Encoding::power;
        stored.gamma = gamma;
    } else if (const std::string profile = profile_other_than_srgb(icc_profile(spec)); !profile.empty()) {
        stored.unknown_space = profile;
    } else if (!space.empty() && space != "srgb" && space != "rec709" && !space.starts_with("gamma")) {
        stored.unknown_space = spec.get_string_attribute("oiio:ColorSpace");
    }
}

/// Names and the place of alpha; GIF's reader places it behind the last channel, and TIFF's calls grey red.
void read_channels(const OIIO::ImageSpec& spec, StoredImage& stored) {
    stored.channels.assign(spec.channelnames.begin(), spec.channelnames.end());
    stored.channels.resize(static_cast<std::size_t>(spec.nchannels), "unnamed");
    stored.alpha = spec.alpha_channel;
    if (stored.alpha >= spec.nchannels) stored.alpha = spec.nchannels == 4 ? 3 : -1;
    constexpr int kWhiteIsZero = 0, kBlackIsZero = 1;
    const int photometric = spec.get_int_attribute("tiff:PhotometricInterpretation", -1);
    if (photometric == kWhiteIsZero || photometric == kBlackIsZero) stored.channels[0] = "Y";
}

/// EXR's colours are multiplied by alpha, TIFF's where the file says so; the other readers keep what is stored, and
/// that is not multiplied.
bool is_multiplied_by_alpha(const OIIO::ImageInput& input, const OIIO::ImageSpec& spec) {
    const std::string format = input.format_name();
    if (spec.get_int_attribute("oiio:UnassociatedAlpha", 0) != 0) return false;
    return format == "openexr" || format == "tiff" || format == "webp";
}

/// libtiff turns images of some colour spaces by itself, and not all the way: such files are refused.
void check_orientation_of_tiff(const std::string& path, const OIIO::ImageSpec& spec, int orientation) {
    constexpr int kMostPlain = 3, kSeparated = 5;  // grey, RGB and palette; CMYK
    const int photometric = spec.get_int_attribute("tiff:PhotometricInterpretation", -1);
    if (orientation == 1 || photometric <= kMostPlain || photometric == kSeparated) return;
    throw UserError(Place{path}, "holds neither grey, RGB nor CMYK colours and is stored turned (Orientation " +
                                     std::to_string(orientation) + "): save it upright, or as RGB");
}

/// A file may hold several images: parts of an EXR, pages of a TIFF. Says that the first one is read.
void remark_parts(const std::string& path, OIIO::ImageInput& input, StoredImage& stored) {
    constexpr int kMost = 6;
    const auto name = [&] { return on_one_line(std::string(input.spec().get_string_attribute("oiio:subimagename"))); };
    const std::string first = name();
    std::string others;
    int count = 1;
    for (; count <= kMost && input.seek_subimage(count, 0); ++count) {
        if (!name().empty()) others += (others.empty() ? "" : ", ") + path_in_quotes(name());
    }
    if (!input.seek_subimage(0, 0))
        throw UserError(Place{path}, "is damaged: " + reason_of(input.geterror(), "no first image"));
    if (count == 1) return;
    const std::string named = first.empty() ? "" : ", " + path_in_quotes(first);
    const std::string left = others.empty() ? "" : ", and not " + others + (count > kMost ? ", ..." : "");
    stored.remarks.push_back("holds more than one image; the first is read" + named + left);
}

/// As EXIF counts. Where the file's own header was read, that counts.
int orientation_of(const std::string& path, const OpenedImage& opened, StoredImage& stored) {
    if (opened.radiance.orientation > 0) return opened.radiance.orientation;
    const OIIO::ImageSpec& spec = opened.input->spec();
    int orientation = opened.webp_orientation;
    if (orientation == 0) orientation = spec.get_int_attribute("Orientation", 1);
    check_orientation_of_tiff(path, spec, orientation);
    if (orientation >= 2 && orientation <= 8) {
        stored.remarks.push_back("is stored turned (Orientation " + std::to_string(orientation) +
                                 "); it was set upright");
    }
    return orientation;
}

void divide_by_multiplier(raster::Image& image, const RadianceHeader& radiance) {
    for (int c = 0; c < std::min(image.channels, 3); ++c) {
        const float multiplier = radiance.multiplier[static_cast<std::size_t>(c)];
        for (std::size_t i = 0; i < image.plane_size(); ++i) image.plane(c)[i] /= multiplier;
    }
}

/// The child process that decodes may use what a picture of this size needs: its values as they are stored, as the
/// library gives them, in planes, and turned. The slowest format takes a second for five million values.
void allow_for_size(std::int64_t values) {
    constexpr std::int64_t kCopies = 4, kValuesInSecond = 5'000'000;
    allow_more(kCopies * values * std::int64_t(sizeof(float)), static_cast<int>(values / kValuesInSecond));
}

/// What the library says of a picture that it gives all the same. JPEG's and TIFF's readers make grey or black of what
/// is not there: an error. Odd bytes between the parts of a JPEG cost nothing that can be seen.
void judge_complaint(const std::string& path, const std::string& complaint, StoredImage& stored) {
    const bool has_odd_bytes = complaint.find("extraneous bytes") != std::string::npos;
    if (!has_odd_bytes) throw UserError(Place{path}, "is damaged: " + complaint);
    stored.remarks.push_back("has odd bytes (" + on_one_line(complaint) + ")");
}

StoredImage read_opened(const std::string& path, const OpenedImage& opened, const ImageReadOptions& options) {
    OIIO::ImageInput& input = *opened.input;
    const OIIO::ImageSpec spec = input.spec();
    check_size(path, spec, options);
    const std::int64_t values = std::int64_t(spec.width) * spec.height * spec.nchannels;
    allow_for_size(std::max(values, std::int64_t(spec.full_width) * spec.full_height * spec.nchannels));
    std::vector<float> data(static_cast<std::size_t>(values));
    if (!input.read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, data.data())) {
        throw UserError(Place{path}, "is damaged: " + reason_of(input.geterror(), "its pixels cannot be decoded"));
    }
    StoredImage stored;
    stored.remarks = opened.radiance.remarks;
    if (input.has_error()) judge_complaint(path, reason_of(input.geterror(), "it is cut off"), stored);
    remark_parts(path, input, stored);
    stored.bits = bits_of(spec);
    read_encoding(spec, stored);
    read_channels(spec, stored);
    stored.image = upright(display_window(spec, data), orientation_of(path, opened, stored));
    divide_by_multiplier(stored.image, opened.radiance);
    if (stored.alpha >= 0 && is_multiplied_by_alpha(input, spec)) {
        divide_by_alpha(stored.image, color_channels(stored.channels, stored.alpha), stored.alpha);
        stored.is_divided = true;
    }
    return stored;
}

/// `open` gives the opened image.
template <class Open>
StoredImage read_quietly(const std::string& path, const ImageReadOptions& options, Open open) {
#if defined(KREDA_COVERAGE)
    const WriteCounts at_end;
#endif
    const QuietLibraries quiet;
    try {
        return read_opened(path, open(), options);
    } catch (const UserError&) {
        throw;
    } catch (const std::exception& damage) {  // the library's own, on headers that make no sense
        throw UserError(Place{path}, "is damaged: " + reason_of_exception(damage));
    }
}

}  // namespace

StoredImage read_stored_image(const std::string& path, const ImageReadOptions& options) {
    return read_quietly(path, options, [&] { return open_image(path); });
}

StoredImage read_stored_bytes(const std::string& name, const std::string& bytes, const ImageReadOptions& options) {
    return read_quietly(name, options, [&] { return open_image_in_memory(name, bytes); });
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
                                                  .read_stored_bytes = kreda::scene::read_stored_bytes,
                                                  .encode_exr = kreda::scene::encode_exr};
    return &module;
}
