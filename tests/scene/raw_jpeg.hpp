// JPEG files byte by byte: grey pictures whose every block takes two bits a component, one where they are progressive.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

namespace kreda::tests {

struct RawJpeg {
    int width = 16, height = 16;  ///< multiples of 8
    bool is_progressive = false;  ///< its decoder keeps the whole picture; the file holds the scan of means alone
    std::string profile = {};     ///< the content of a segment APP2, where colour profiles stand
};

/// A segment: its marker, its length, its content.
[[nodiscard]] inline std::string jpeg_segment(int marker, const std::string& content) {
    const std::size_t size = content.size() + 2;
    return std::string("\xff") + static_cast<char>(marker) + static_cast<char>(size >> 8) + static_cast<char>(size) +
           content;
}

/// ITU-T T.81: quantization all 1; Huffman codes of one symbol, 0, whose code is one bit, 0: no difference, no more
/// coefficients.
[[nodiscard]] inline std::string raw_jpeg(const RawJpeg& jpeg) {
    constexpr int kBaseline = 0xc0, kProgressive = 0xc2, kTables = 0xdb, kCodes = 0xc4, kScan = 0xda, kProfile = 0xe2;
    const auto two_bytes = [](int value) {
        return std::string(1, static_cast<char>(value >> 8)) + static_cast<char>(value);
    };
    const std::string frame =
        '\x08' + two_bytes(jpeg.height) + two_bytes(jpeg.width) + std::string("\3\1\x11\0\2\x11\0\3\x11\0", 10);
    std::string file = "\xff\xd8";
    if (!jpeg.profile.empty()) file += jpeg_segment(kProfile, jpeg.profile);
    file += jpeg_segment(kTables, std::string(1, '\0') + std::string(64, '\1'));
    file += jpeg_segment(jpeg.is_progressive ? kProgressive : kBaseline, frame);
    for (const char table : {'\0', '\x10'}) {
        file += jpeg_segment(kCodes, std::string(1, table) + '\1' + std::string(15, '\0') + '\0');
    }
    const char last = jpeg.is_progressive ? '\0' : '\x3f';
    file += jpeg_segment(kScan, std::string("\3\1\0\2\0\3\0\0", 8) + last + '\0');
    const int all_blocks = jpeg.width / 8 * (jpeg.height / 8);
    const int blocks = std::min(all_blocks, 4096);  // a large picture is only promised
    const std::size_t bits = static_cast<std::size_t>(blocks) * 3 * (jpeg.is_progressive ? 1 : 2);
    std::string data(bits / 8, '\0');
    if (bits % 8 != 0) data += static_cast<char>(0xff >> bits % 8);  // the last byte is filled with ones
    return file + data + "\xff\xd9";
}

}  // namespace kreda::tests
