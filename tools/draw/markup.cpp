#include "tools/draw/markup.hpp"

#include <cstddef>

namespace kreda::tools {

namespace {

constexpr char32_t kBroken = 0xfffd;

/// The code point that begins at `at`, which moves on; one byte only where this is no UTF-8.
char32_t next_code_point(std::string_view utf8, std::size_t& at) {
    const auto lead = static_cast<unsigned char>(utf8[at++]);
    if (lead < 0x80) return lead;
    const int more = lead >= 0xf8 ? 0 : lead >= 0xf0 ? 3 : lead >= 0xe0 ? 2 : lead >= 0xc2 ? 1 : 0;
    if (more == 0 || at + static_cast<std::size_t>(more) > utf8.size()) return kBroken;
    char32_t point = lead & (0x3fu >> more);
    for (int i = 0; i < more; ++i) {
        const auto byte = static_cast<unsigned char>(utf8[at + static_cast<std::size_t>(i)]);
        if ((byte & 0xc0u) != 0x80u) return kBroken;
        point = point << 6 | (byte & 0x3fu);
    }
    at += static_cast<std::size_t>(more);
    return point;
}

/// Letters that stand for a quantity; digits, brackets, signs and capital Greek stay upright.
bool is_symbol(char32_t c) {
    return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z') || (c >= 0x3b1 && c <= 0x3f5);
}

void append(std::vector<TypeRun>& runs, char32_t c, bool italic, Script script) {
    if (runs.empty() || runs.back().italic != italic || runs.back().script != script) {
        runs.push_back({{}, italic, script});
    }
    runs.back().text += c;
}

}  // namespace

std::u32string code_points(std::string_view utf8) {
    std::u32string points;
    for (std::size_t at = 0; at < utf8.size();) points += next_code_point(utf8, at);
    return points;
}

std::vector<TypeRun> parse_markup(std::string_view markup) {
    const std::u32string text = code_points(markup);
    std::vector<TypeRun> runs;
    bool formula = false, braces = false;
    Script script = Script::none;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char32_t c = text[i];
        const bool escaped = c == U'\\' && i + 1 < text.size() && text[i + 1] == U'$';
        if (c == U'$') {
            formula = !formula;
            script = Script::none;
            braces = false;
        } else if (formula && !braces && (c == U'_' || c == U'^')) {
            script = c == U'_' ? Script::sub : Script::super;
        } else if (formula && script != Script::none && c == U'{') {
            braces = true;
        } else if (formula && braces && c == U'}') {
            braces = false;
            script = Script::none;
        } else {
            append(runs, escaped ? text[++i] : c, formula && is_symbol(c), script);
            if (!braces) script = Script::none;
        }
    }
    return runs;
}

std::string plain_markup(std::string_view text) {
    std::string markup;
    for (const char c : text) markup += c == '$' ? std::string("\\$") : std::string(1, c);
    return markup;
}

}  // namespace kreda::tools
