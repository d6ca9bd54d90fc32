#include "scene/files/obj_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <system_error>
#include <utility>

#include "scene/files/file_content.hpp"

namespace kreda::scene {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxBytes = std::uintmax_t(1) << 30;

bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}
bool is_capital(char c) {
    return c >= 'A' && c <= 'Z';
}
bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

std::string read_bytes(const std::string& path, std::size_t size) {
    std::ifstream stream(path, std::ios::binary);
    std::string bytes(size, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(size));
    if (!stream) throw UserError(Place{path}, "cannot be read; check its permissions");
    return bytes;
}

std::string visible(std::string_view words) {
    std::string text;
    for (const char c : words) text += (c >= 0 && c < ' ') ? '?' : c;
    return text;
}

bool has_negative_exponent(std::string_view number) {
    return number.find("e-") != number.npos || number.find("E-") != number.npos;
}

}  // namespace

ObjText check_obj_text(const std::string& file, std::string bytes) {
    const std::string_view start = std::string_view(bytes).substr(0, 2);
    if (start == "\xff\xfe" || start == "\xfe\xff") {
        throw UserError(Place{file}, "is UTF-16 text; save it as UTF-8");
    }
    if (std::string_view(bytes).substr(0, 3) == "\xef\xbb\xbf") bytes.erase(0, 3);
    if (const std::string other = other_content(bytes); !other.empty()) throw UserError(Place{file}, other);
    ObjText text{file, std::move(bytes)};
    const std::size_t zero = text.text.find('\0');
    if (zero != std::string::npos) {
        throw UserError(place_at(text, zero), "is binary data (a zero byte); OBJ and MTL are UTF-8 text");
    }
    return text;
}

std::size_t size_of_mesh_file(const std::string& path) {
    std::error_code failed;
    const fs::file_status status = fs::status(path, failed);
    if (!fs::exists(status)) throw UserError(Place{path}, "no such file");
    if (fs::is_directory(status)) throw UserError(Place{path}, "is a folder; a file is needed");
    if (!fs::is_regular_file(status)) throw UserError(Place{path}, "is not a regular file");
    const std::uintmax_t size = fs::file_size(path, failed);
    if (failed) throw UserError(Place{path}, "cannot be read: " + failed.message());
    if (size > kMaxBytes) throw UserError(Place{path}, "is larger than 1 GB; reduce the mesh or split it");
    return static_cast<std::size_t>(size);
}

ObjText read_obj_text(const std::string& path) {
    return check_obj_text(path, read_bytes(path, size_of_mesh_file(path)));
}

void ObjWarnings::add(std::string_view kind, std::size_t offset, const std::string& message) {
    add_line(kind, has_enough_of(kind) ? "" : warning_at(text_, offset, message));
}

bool ObjWarnings::has_enough_of(std::string_view kind) const {
    const auto found =
        std::find_if(kinds_.begin(), kinds_.end(), [&](const Kind& known) { return known.name == kind; });
    return found != kinds_.end() && found->count >= kMost;
}

void ObjWarnings::add_line(std::string_view kind, const std::string& line) {
    auto found = std::find_if(kinds_.begin(), kinds_.end(), [&](const Kind& known) { return known.name == kind; });
    if (found == kinds_.end()) found = kinds_.insert(kinds_.end(), Kind{std::string(kind), {}, 0});
    if (found->count++ < kMost) found->lines.push_back(line);
}

std::vector<std::string> ObjWarnings::lines() const {
    std::vector<std::string> all;
    for (const Kind& kind : kinds_) {
        all.insert(all.end(), kind.lines.begin(), kind.lines.end());
        const std::size_t more = kind.count - kind.lines.size();
        if (more > 0) all.push_back(text_.file + ": and " + std::to_string(more) + " more: " + kind.name);
    }
    return all;
}

std::string token_in_quotes(std::string_view token) {
    constexpr std::size_t kLongest = 40;
    return "'" + visible(token.substr(0, kLongest)) + (token.size() > kLongest ? "...'" : "'");
}

std::string in_lower_case(std::string_view word) {
    std::string lower(word);
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
}

Place place_at(const ObjText& text, std::size_t offset) {
    Place place{text.file, 1, 1};
    for (std::size_t i = 0; i < offset && i < text.text.size(); ++i) {
        const char c = text.text[i];
        const bool first_of_crlf = c == '\r' && i + 1 < text.text.size() && text.text[i + 1] == '\n';
        if (is_line_end(c) && !first_of_crlf) {
            ++place.line;
            place.column = 1;
        } else {
            ++place.column;
        }
    }
    return place;
}

std::string warning_at(const ObjText& text, std::size_t offset, const std::string& message) {
    return UserError(place_at(text, offset), message).what();
}

/// A backslash that is the last character of its line.
bool ObjCursor::continues(std::size_t i) const {
    return at(i) == '\\' && is_line_end(at(i + 1));
}

bool ObjCursor::ends_token(std::size_t i) const {
    return is_blank(at(i)) || is_line_end(at(i)) || continues(i);
}

void ObjCursor::skip_blanks() {
    while (true) {
        while (at(position_) == ' ') ++position_;
        if (is_blank(at(position_))) {
            ++position_;
        } else if (continues(position_)) {
            const bool crlf = at(position_ + 1) == '\r' && at(position_ + 2) == '\n';
            position_ = std::min(position_ + (crlf ? 3 : 2), text_.text.size());
        } else {
            return;
        }
    }
}

std::string_view ObjCursor::next_token() {
    skip_blanks();
    const std::size_t first = position_;
    while (!ends_token(position_)) ++position_;
    return std::string_view(text_.text).substr(first, position_ - first);
}

std::string_view ObjCursor::next_number_token() {
    skip_blanks();
    const std::size_t first = position_;
    while (!ends_token(position_)) {
        const bool is_in_number = position_ > first && at(position_ - 1) == '.' && is_capital(at(position_ + 1));
        if (at(position_) == '#' && !is_in_number) break;
        ++position_;
    }
    return std::string_view(text_.text).substr(first, position_ - first);
}

std::string_view ObjCursor::rest_of_text() {
    skip_blanks();
    return std::string_view(text_.text).substr(position_, end_ - position_);
}

bool ObjCursor::take_up_to(const char* p) {
    const std::size_t end = offset_of({p, 0});  // NOLINT(bugprone-string-constructor): a place, no text
    if (end < end_ && !is_blank(at(end)) && !is_line_end(at(end))) return false;
    position_ = end;
    return true;
}

bool ObjCursor::take_number(double& number) {
    const std::string_view rest = rest_of_text();
    double value = 0.0;
    const std::from_chars_result result = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    const bool is_plain = result.ec == std::errc() && std::abs(value) <= double(std::numeric_limits<float>::max());
    if (!is_plain || !take_up_to(result.ptr)) return false;
    number = value;
    return true;
}

std::string ObjCursor::rest_of_statement() {
    std::string rest;
    for (std::string_view word = next_token(); !word.empty(); word = next_token()) {
        const std::size_t first = offset_of(word);
        // Blanks inside a name are part of it; only a continuation's line end becomes one blank.
        while (is_blank(at(position_))) ++position_;
        if (!rest.empty() && !is_blank(rest.back())) rest += ' ';
        rest += text_.text.substr(first, position_ - first);
    }
    while (!rest.empty() && is_blank(rest.back())) rest.pop_back();
    return rest;
}

void ObjCursor::skip_statement() {
    const std::string& text = text_.text;
    if (at(position_) == '#') return skip_line();  // where a number stopped
    while (position_ < text.size() && !is_line_end(text[position_])) {
        const bool starts_comment = text[position_] == '#' && (position_ == 0 || is_blank(at(position_ - 1)));
        if (starts_comment) break;
        if (continues(position_)) {
            skip_blanks();
        } else {
            ++position_;
        }
    }
    skip_line();
}

void ObjCursor::skip_line() {
    const std::string& text = text_.text;
    while (position_ < text.size() && !is_line_end(text[position_])) ++position_;
    if (at(position_) == '\r' && at(position_ + 1) == '\n') ++position_;
    position_ = std::min(position_ + 1, text.size());
}

void ObjCursor::fail(std::string_view token, const std::string& message) const {
    const std::string found = token.empty() ? "the line ends" : token_in_quotes(token);
    throw UserError(place_at(text_, offset_of(token)), found + ": " + message);
}

double parse_finite(const ObjCursor& cursor, std::string_view token, const char* what) {
    const auto expected = [&] { return std::string("expected ") + what; };
    if (token.empty()) cursor.fail(token, expected());
    const bool plus = token.front() == '+' && token.size() > 1 && token[1] != '-';
    double value = 0.0;
    const char* end = token.data() + token.size();
    const std::from_chars_result result = std::from_chars(token.data() + (plus ? 1 : 0), end, value);
    if (result.ec == std::errc::invalid_argument) cursor.fail(token, expected() + ", a number");
    if (result.ptr != end) {
        const bool comma = *result.ptr == ',';
        cursor.fail(token, expected() + (comma ? "; write decimals with a point, 1.5 and not 1,5" : ", a number"));
    }
    // Out of range is either far too large or so small that it is 0; a negative exponent tells which.
    if (result.ec == std::errc::result_out_of_range && has_negative_exponent(token)) return 0.0;
    if (result.ec == std::errc::result_out_of_range || !std::isfinite(value) ||
        std::abs(value) > double(std::numeric_limits<float>::max())) {
        cursor.fail(token, expected() + " that is finite, at most 3.4e38");
    }
    return value;
}

}  // namespace kreda::scene
