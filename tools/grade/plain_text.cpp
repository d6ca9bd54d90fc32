#include "tools/grade/plain_text.hpp"

#include <cstdint>
#include <cstdio>

#include "tools/escape_html.hpp"

namespace kreda::tools {

namespace {

/// The length of the valid character at `i`, or 0.    RFC 3629, section 4
std::size_t character_length(std::string_view text, std::size_t i) {
    const auto byte = [&](std::size_t k) -> std::uint32_t {
        return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0u;
    };
    const std::uint32_t first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t length = first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
    std::uint32_t code = first & (0xFFu >> (length + 1));
    for (std::size_t k = 1; k < length; ++k) {
        if ((byte(k) & 0xC0u) != 0x80u) return 0;
        code = code << 6 | (byte(k) & 0x3Fu);
    }
    const bool is_short_enough = length < 3 || code >= (length == 3 ? 0x800u : 0x10000u);
    const bool is_character = code < 0xD800 || (code > 0xDFFF && code != 0xFFFE && code != 0xFFFF && code < 0x110000);
    return is_short_enough && is_character ? length : 0;
}

}  // namespace

std::string plain_text(std::string_view text, std::size_t most) {
    std::string plain;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = character_length(text, i);
        const auto c = static_cast<unsigned char>(text[i]);
        const bool is_control = (c < 0x20 && c != '\n' && c != '\t') || c == 0x7F;
        if (plain.size() + length > most) return plain + "\n... (" + std::to_string(text.size() - i) + " bytes more)";
        if (length == 0 || is_control) {
            plain += '?';
        } else {
            plain += text.substr(i, length);
        }
        i += length == 0 ? 1 : length;
    }
    return plain;
}

std::string markup_text(std::string_view text) {
    return escape_html(plain_text(text));
}

std::string first_line(std::string_view text) {
    return std::string(text.substr(0, text.find('\n')));
}

std::string points_text(double points) {
    char text[48];
    std::snprintf(text, sizeof text, "%.3f", points);
    std::string number = text;
    while (number.back() == '0') number.pop_back();
    if (number.back() == '.') number.pop_back();
    return number == "-0" ? "0" : number;
}

}  // namespace kreda::tools
