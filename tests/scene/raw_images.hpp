// Image files byte by byte, in forms that the program itself never writes: TIFF, TGA, WebP, Radiance.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace kreda::tests {

[[nodiscard]] inline std::string little_endian(std::uint64_t value, int bytes) {
    std::string text;
    for (; bytes > 0; --bytes, value >>= 8) text += static_cast<char>(value & 0xff);
    return text;
}

/// EXIF data with one entry, the orientation.
[[nodiscard]] inline std::string raw_exif(int orientation) {
    return std::string("II*\0\x08\0\0\0\x01\0", 10) + little_endian(274, 2) + little_endian(3, 2) +
           little_endian(1, 4) + little_endian(std::uint64_t(orientation), 4) + little_endian(0, 4);
}

/// What a TIFF says of its pixels. extra: ExtraSamples, 1 multiplied by alpha, 2 not, 0 none.
struct RawTiff {
    int width = 1, height = 1, samples = 3, bits = 8;
    int photometric = 2, orientation = 1, extra = 0;
    bool is_float = false;
};

/// An uncompressed little-endian TIFF of one strip.
[[nodiscard]] inline std::string raw_tiff(const RawTiff& tiff, const std::string& pixels) {
    struct Entry {
        int tag, type;
        std::uint64_t value;
    };
    const std::uint64_t size = pixels.size(), samples = std::uint64_t(tiff.samples);
    std::vector<Entry> entries = {{256, 4, std::uint64_t(tiff.width)},       {257, 4, std::uint64_t(tiff.height)},
                                  {258, 3, std::uint64_t(tiff.bits)},        {259, 3, 1},
                                  {262, 3, std::uint64_t(tiff.photometric)}, {273, 4, 0},
                                  {274, 3, std::uint64_t(tiff.orientation)}, {277, 3, samples},
                                  {278, 4, std::uint64_t(tiff.height)},      {279, 4, size}};
    if (tiff.extra > 0) entries.push_back({338, 3, std::uint64_t(tiff.extra)});
    if (tiff.is_float) entries.push_back({339, 3, 3});
    const std::uint64_t after = 8 + 2 + 12 * entries.size() + 4;
    const bool has_list = samples > 2;  // the bits of more than two samples stand behind the directory
    const std::uint64_t list_bytes = has_list ? 2 * samples : 0;
    std::string file = std::string("II*\0\x08\0\0\0", 8) + little_endian(entries.size(), 2);
    for (const Entry& entry : entries) {
        const bool is_bits = entry.tag == 258;
        std::uint64_t value = entry.tag == 273 ? after + list_bytes : entry.value;
        if (is_bits && samples == 2) value = value << 16 | value;
        if (is_bits && has_list) value = after;
        file += little_endian(std::uint64_t(entry.tag), 2) + little_endian(std::uint64_t(entry.type), 2) +
                little_endian(is_bits ? samples : 1, 4) + little_endian(value, 4);
    }
    file += little_endian(0, 4);
    for (std::uint64_t i = 0; has_list && i < samples; ++i) file += little_endian(std::uint64_t(tiff.bits), 2);
    return file + pixels;
}

/// An uncompressed TGA of 32 bits a pixel (blue, green, red, alpha), the first row on top, alpha not multiplied.
[[nodiscard]] inline std::string raw_tga(int width, int height, const std::string& bgra) {
    return std::string("\0\0\x02\0\0\0\0\0\0\0\0\0", 12) + little_endian(std::uint64_t(width), 2) +
           little_endian(std::uint64_t(height), 2) + "\x20\x28" + bgra;
}

/// A lossless WebP, all pixels alike: five codes of one symbol each, so that a pixel takes no bits at all.
[[nodiscard]] inline std::string raw_webp(int width, int height, const std::string& rgba, int orientation = 0) {
    std::vector<bool> bits;
    const auto put = [&](unsigned value, int count) {
        for (int i = 0; i < count; ++i) bits.push_back((value >> i & 1u) != 0);
    };
    put(0x2f, 8);
    put(unsigned(width - 1), 14);
    put(unsigned(height - 1), 14);
    put(1, 1);  // has alpha
    put(0, 6);  // version 0; no transform, no colour cache, no code image
    for (const std::size_t channel : {1u, 0u, 2u, 3u}) {
        put(0b101, 3);  // a simple code, of one symbol, of eight bits
        put(static_cast<unsigned char>(rgba[channel]), 8);
    }
    put(0b0001, 4);  // the code of distances: a simple one, of one symbol, of one bit, which is 0
    std::string data((bits.size() + 7) / 8 + 4, '\0');
    for (std::size_t i = 0; i < bits.size(); ++i) data[i / 8] = static_cast<char>(data[i / 8] | int(bits[i]) << i % 8);
    const auto chunk = [](const std::string& name, const std::string& content) {
        return name + little_endian(content.size(), 4) + content + std::string(content.size() % 2, '\0');
    };
    std::string body = "WEBP";
    if (orientation > 0) {
        body += chunk("VP8X", little_endian(0x18, 4) + little_endian(std::uint64_t(width - 1), 3) +
                                  little_endian(std::uint64_t(height - 1), 3));
    }
    body += chunk("VP8L", data);
    if (orientation > 0) body += chunk("EXIF", raw_exif(orientation));
    return chunk("RIFF", body);
}

/// A pixel of a Radiance picture whose three values are this whole number, 0 to 255.
[[nodiscard]] inline std::string radiance_pixel(int value) {
    return std::string(3, static_cast<char>(value)) + static_cast<char>(128 + 8);
}

/// A flat Radiance picture; `variables` are whole lines.
[[nodiscard]] inline std::string raw_radiance(const std::string& variables, const std::string& sizes,
                                              const std::string& pixels) {
    return "#?RADIANCE\n" + variables + "FORMAT=32-bit_rle_rgbe\n\n" + sizes + "\n" + pixels;
}

}  // namespace kreda::tests
