#include "scene/files/webp_file.hpp"

#include <cstdint>

#include "scene/files/image_orientation.hpp"

namespace kreda::scene {

namespace {

constexpr std::size_t kFirstChunk = 12;
constexpr std::size_t kChunkHeader = 8;

/// Calls visit(name, offset of the data, size of the data) for every chunk that is whole.
template <class Visit>
void for_each_chunk(std::string_view bytes, Visit visit) {
    std::size_t at = kFirstChunk;
    while (at + kChunkHeader <= bytes.size()) {
        std::size_t size = 0;
        for (std::size_t i = 0; i < 4; ++i) size |= std::size_t(static_cast<unsigned char>(bytes[at + 4 + i])) << 8 * i;
        if (size > bytes.size() - at - kChunkHeader) return;
        visit(bytes.substr(at, 4), at + kChunkHeader, size);
        at += kChunkHeader + size + size % 2;
    }
}

}  // namespace

bool is_webp(std::string_view bytes) {
    return bytes.starts_with("RIFF") && bytes.substr(0, kFirstChunk).ends_with("WEBP");
}

std::string webp_without_alpha(std::string_view bytes) {
    std::string result(bytes);
    for_each_chunk(bytes, [&](std::string_view name, std::size_t data, std::size_t size) {
        constexpr int kExtendedHasAlpha = 0x10;  // in the first byte of VP8X
        constexpr int kLosslessHasAlpha = 0x10;  // bit 28 after the signature 0x2f
        if (name == "VP8X" && size >= 1) result[data] = static_cast<char>(result[data] & ~kExtendedHasAlpha);
        if (name == "VP8L" && size >= 5) result[data + 4] = static_cast<char>(result[data + 4] & ~kLosslessHasAlpha);
    });
    return result;
}

int webp_orientation(std::string_view bytes) {
    int orientation = 1;
    for_each_chunk(bytes, [&](std::string_view name, std::size_t data, std::size_t size) {
        if (name == "EXIF") orientation = exif_orientation(bytes.substr(data, size));
    });
    return orientation;
}

}  // namespace kreda::scene
