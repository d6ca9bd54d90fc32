#include "scene/files/deflate_strips.hpp"

#include <algorithm>
#include <new>

#include <zlib.h>

namespace kreda::scene {

namespace {

constexpr std::size_t kStrip = std::size_t{1} << 18;       // bytes; a megapixel has a dozen strips
constexpr std::size_t kDictionary = std::size_t{1} << 15;  // how far back deflate looks
constexpr int kLevel = 6;

/// A strip of the bytes, deflated (RFC 1951), and its checksum.
struct Strip {
    std::vector<unsigned char> deflated;
    uLong adler = 0;
    bool failed = false;
};

/// zlib wants pointers to what it does not write.
Bytef* at(std::span<const unsigned char> bytes) {
    return const_cast<Bytef*>(bytes.data());
}

/// Deflate bytes[first ...]; what stands before them may be referred to.
Strip deflate_strip(std::span<const unsigned char> bytes, std::size_t first) {
    const std::span<const unsigned char> strip = bytes.subspan(first, std::min(kStrip, bytes.size() - first));
    const std::size_t back = std::min(first, kDictionary);
    const bool is_last = first + strip.size() == bytes.size();
    Strip made;
    z_stream stream{};
    if (deflateInit2(&stream, kLevel, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY) != Z_OK) throw std::bad_alloc();
    if (back > 0) deflateSetDictionary(&stream, at(bytes.subspan(first - back)), static_cast<uInt>(back));
    made.deflated.resize(deflateBound(&stream, strip.size()) + 16);
    stream.next_in = at(strip);
    stream.avail_in = static_cast<uInt>(strip.size());
    stream.next_out = made.deflated.data();
    stream.avail_out = static_cast<uInt>(made.deflated.size());
    deflate(&stream, is_last ? Z_FINISH : Z_SYNC_FLUSH);  // flushed, a strip ends with a whole byte
    made.deflated.resize(stream.total_out);
    deflateEnd(&stream);
    made.adler = adler32(1, at(strip), static_cast<uInt>(strip.size()));
    return made;
}

}  // namespace

std::vector<std::vector<unsigned char>> deflate_strips(std::span<const unsigned char> bytes) {
    const int count = static_cast<int>(std::max<std::size_t>(1, (bytes.size() + kStrip - 1) / kStrip));
    std::vector<Strip> strips(static_cast<std::size_t>(count));
#pragma omp parallel for schedule(dynamic)
    for (int s = 0; s < count; ++s) {
        const auto number = static_cast<std::size_t>(s);
        try {
            strips[number] = deflate_strip(bytes, number * kStrip);
        } catch (const std::bad_alloc&) {  // an exception must not leave the threads' loop
            strips[number].failed = true;
        }
    }
    std::vector<std::vector<unsigned char>> parts = {{0x78, 0x9c}};  // deflate, looking back 32 KB, the usual level
    uLong adler = 1;
    for (std::size_t s = 0; s < strips.size(); ++s) {
        if (strips[s].failed) throw std::bad_alloc();
        const std::size_t size = std::min(kStrip, bytes.size() - s * kStrip);
        adler = adler32_combine(adler, strips[s].adler, static_cast<z_off_t>(size));
        parts.push_back(std::move(strips[s].deflated));
    }
    const auto byte = [&](int shift) { return static_cast<unsigned char>(adler >> shift & 255); };
    parts.push_back({byte(24), byte(16), byte(8), byte(0)});
    return parts;
}

}  // namespace kreda::scene
