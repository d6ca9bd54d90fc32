#include "scene/files/quoted_text.hpp"

// A file of its own because the module of images needs it, too.
#include <algorithm>
#include <string>

#include "scene/files/toml_tree.hpp"

namespace kreda::scene {

namespace {

constexpr std::size_t kMaxQuoted = 60;
constexpr std::size_t kQuotedFront = 20;  ///< a long text is told apart by its end

std::string without_controls(std::string_view text) {
    std::string result(text);
    const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7F; };
    std::replace_if(result.begin(), result.end(), is_control, '?');
    return result;
}

}  // namespace

std::string on_one_line(std::string_view text) {
    if (text.size() <= kMaxQuoted) return without_controls(text);
    const auto inside_character = [&](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80; };
    std::size_t front = kQuotedFront;
    std::size_t back = text.size() - (kMaxQuoted - kQuotedFront);
    while (front > 0 && inside_character(front)) --front;
    while (back < text.size() && inside_character(back)) ++back;
    return without_controls(text.substr(0, front)) + "..." + without_controls(text.substr(back));
}

std::string in_quotes(std::string_view text, char quote) {
    return quote + on_one_line(text) + quote;
}

std::string path_in_quotes(std::string_view path) {
    const std::size_t name = path.size() - (path.find_last_of("/\\") + 1);  // npos + 1 is 0
    const std::size_t length = std::max(name, kMaxQuoted);
    if (path.size() <= length) return "'" + without_controls(path) + "'";
    std::size_t start = path.size() - length;
    while (start < path.size() && (static_cast<unsigned char>(path[start]) & 0xC0) == 0x80) ++start;
    return "'..." + without_controls(path.substr(start)) + "'";
}

}  // namespace kreda::scene
