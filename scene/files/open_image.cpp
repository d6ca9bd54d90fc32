#include "scene/files/open_image.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "scene/error.hpp"
#include "scene/files/file_content.hpp"
#include "scene/files/webp_file.hpp"

namespace kreda::scene {

namespace {

namespace fs = std::filesystem;

std::string first_bytes(const std::string& path, std::size_t most) {
    std::ifstream file(path, std::ios::binary);
    std::string bytes(most, '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(most));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return bytes;
}

/// `opened.bytes` as an image of that format.
void open_bytes(const std::string& path, const std::string& format, OpenedImage& opened) {
    opened.memory = std::make_unique<OIIO::Filesystem::IOMemReader>(opened.bytes.data(), opened.bytes.size());
    opened.input = OIIO::ImageInput::create(format);
    if (!opened.input)
        throw UserError(Place{path}, "cannot be read as an image: OpenImageIO has no " + format + " here");
    OIIO::ImageSpec spec, wish;
    wish.attribute("oiio:UnassociatedAlpha", 1);  // otherwise PNG's colours come multiplied by alpha
    if (opened.input->set_ioproxy(opened.memory.get()) && opened.input->open(path, spec, wish)) return;
    throw UserError(Place{path}, "is damaged: " + reason_of(opened.input->geterror(), "its pixels cannot be decoded"));
}

void open_webp(const std::string& path, const std::string& bytes, OpenedImage& opened) {
    opened.webp_orientation = webp_orientation(bytes);
    opened.bytes = webp_without_alpha(bytes);
    open_bytes(path, "webp", opened);
}

}  // namespace

std::string reason_of(const std::string& text, const std::string& otherwise) {
    constexpr std::size_t kMostLines = 2;
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        const auto holds_it = [&](const std::string& other) { return other.find(line) != std::string::npos; };
        if (line.empty() || line == "PNG library error") continue;
        if (std::none_of(lines.begin(), lines.end(), holds_it)) lines.push_back(line);
        if (lines.size() == kMostLines) break;
    }
    std::string reason;
    for (const std::string& line : lines) reason += (reason.empty() ? "" : "; ") + line;
    return reason.empty() ? otherwise : reason;
}

OpenedImage open_image_in_memory(const std::string& name, const std::string& bytes) {
    OpenedImage opened;
    if (is_webp(bytes)) {
        open_webp(name, bytes, opened);
        return opened;
    }
    const bool is_png = bytes.starts_with("\x89PNG"), is_jpeg = bytes.starts_with("\xff\xd8\xff");
    const std::string other = other_content(bytes);
    if (!is_png && !is_jpeg) throw UserError(Place{name}, other.empty() ? "is neither a PNG nor a JPEG image" : other);
    opened.bytes = bytes;
    open_bytes(name, is_png ? "png" : "jpeg", opened);
    return opened;
}

OpenedImage open_image(const std::string& path) {
    constexpr std::size_t kMostHeader = 1 << 16;
    const std::string start = first_bytes(path, kMostHeader);
    OpenedImage opened;
    if (is_webp(start)) {
        open_webp(path, first_bytes(path, static_cast<std::size_t>(fs::file_size(path))), opened);
        return opened;
    }
    OIIO::ImageSpec wish;
    wish.attribute("oiio:UnassociatedAlpha", 1);  // otherwise PNG's colours come multiplied by alpha
    opened.input = OIIO::ImageInput::open(path, &wish);
    const std::string other = opened.input ? "" : other_content(start);
    if (!other.empty()) throw UserError(Place{path}, other);
    if (start.starts_with("#?")) opened.radiance = read_radiance_header(start);
    if (opened.radiance.is_xyz) {
        throw UserError(Place{path},
                        "holds XYZ colours (FORMAT=32-bit_rle_xyze); RGB is needed: ra_xyze -r converts it");
    }
    const std::string unknown = "it is of no format that OpenImageIO knows";
    if (!opened.input) {
        throw UserError(Place{path}, "cannot be read as an image: " + reason_of(OIIO::geterror(), unknown));
    }
    return opened;
}

}  // namespace kreda::scene
