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

/// A PNG of 1 x 1 pixel, stored without compression. color_type: 0 grey, 2 RGB, 4 grey with alpha, 6 RGBA.
[[nodiscard]] inline std::string one_pixel_png(int bits, int color_type, const std::string& pixel) {
    const std::string row = std::string(1, '\0') + pixel;  // filter 0
    std::uint32_t s1 = 1, s2 = 0;                          // Adler-32, RFC 1950
    for (const char c : row) {
        s1 = (s1 + static_cast<unsigned char>(c)) % 65521;
        s2 = (s2 + s1) % 65521;
    }
    const std::uint32_t size = static_cast<std::uint32_t>(row.size());
    std::string stream("\x78\x01\x01", 3);
    for (const std::uint32_t length : {size, ~size}) {
        stream += static_cast<char>(length & 0xff);
        stream += static_cast<char>(length >> 8 & 0xff);
    }
    stream += row + big_endian(s2 << 16 | s1);
    std::string header = big_endian(1) + big_endian(1);
    header += static_cast<char>(bits);
    header += static_cast<char>(color_type);
    header += std::string(3, '\0');
    return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + png_chunk("IDAT", stream) + png_chunk("IEND", "");
}

}  // namespace kreda::tests
