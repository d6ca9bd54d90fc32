// PNG files byte by byte, for what the program itself never writes: 16 bits, alpha, promises that are not kept.
#pragma once

#include <cstdint>
#include <string>

namespace kreda::tests {

[[nodiscard]] inline std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
    return bytes;
}

[[nodiscard]] inline std::uint32_t crc32(const std::string& bytes) {
    std::uint32_t crc = 0xffffffffu;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) ? 0xedb88320u : 0u);
    }
    return ~crc;
}

[[nodiscard]] inline std::string png_chunk(const std::string& type, const std::string& data) {
    return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(crc32(type + data));
}

/// A PNG stored without compression. color_type: 0 grey, 2 RGB, 4 grey with alpha, 6 RGBA; `pixels`: row by row, at
/// most 65000 bytes; `chunks`: whole ones that stand before the pixels.
[[nodiscard]] inline std::string raw_png(int width, int height, int bits, int color_type, const std::string& pixels,
                                         const std::string& chunks = "") {
    std::string rows;
    const std::size_t row_bytes = pixels.size() / static_cast<std::size_t>(height);
    for (std::size_t at = 0; at < pixels.size(); at += row_bytes) {
        rows += std::string(1, '\0') + pixels.substr(at, row_bytes);  // filter 0
    }
    std::uint32_t s1 = 1, s2 = 0;  // Adler-32, RFC 1950
    for (const char c : rows) {
        s1 = (s1 + static_cast<unsigned char>(c)) % 65521;
        s2 = (s2 + s1) % 65521;
    }
    const std::uint32_t size = static_cast<std::uint32_t>(rows.size());
    std::string stream("\x78\x01\x01", 3);
    for (const std::uint32_t length : {size, ~size}) {
        stream += static_cast<char>(length & 0xff);
        stream += static_cast<char>(length >> 8 & 0xff);
    }
    stream += rows + big_endian(s2 << 16 | s1);
    std::string header = big_endian(static_cast<std::uint32_t>(width)) + big_endian(static_cast<std::uint32_t>(height));
    header += static_cast<char>(bits);
    header += static_cast<char>(color_type);
    header += std::string(3, '\0');
    return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + chunks + png_chunk("IDAT", stream) + png_chunk("IEND", "");
}

/// A PNG of 1 x 1 pixel.
[[nodiscard]] inline std::string one_pixel_png(int bits, int color_type, const std::string& pixel) {
    return raw_png(1, 1, bits, color_type, pixel);
}

}  // namespace kreda::tests
