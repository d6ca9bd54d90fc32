// What OBJ and MTL files have in common: reading the text, places in it, its tokens, paths that it names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/error.hpp"
#include "scene/files/quoted_text.hpp"

namespace kreda::scene {

/// A text with the name it has in messages.
struct ObjText {
    std::string file;
    std::string text;
};

/// Read a whole text file. Refuses folders, devices, files above 1 GB, UTF-16 and binary data; strips a UTF-8
/// byte-order mark.
/// Bytes of a mesh file of any format. Throws UserError for what is no file, and for more than 1 GB.
[[nodiscard]] std::size_t size_of_mesh_file(const std::string& path);

[[nodiscard]] ObjText read_obj_text(const std::string& path);

/// The same checks on bytes that are there already.
[[nodiscard]] ObjText check_obj_text(const std::string& file, std::string bytes);

/// Line and column of a byte; lines end with \n, \r\n or \r. Counts from the start: for complaints only.
[[nodiscard]] Place place_at(const ObjText& text, std::size_t offset);

/// "FILE:LINE:COL: message", as UserError writes it.
[[nodiscard]] std::string warning_at(const ObjText& text, std::size_t offset, const std::string& message);

/// Warnings of one text: of each kind the first ten with their places, then how many more there are. A broken file must
/// not bury the terminal.
class ObjWarnings {
public:
    explicit ObjWarnings(const ObjText& text) : text_(text) {}

    /// `kind` is what warnings that say the same have in common, in words that fit behind "and 7 more: ".
    void add(std::string_view kind, std::size_t offset, const std::string& message);
    /// The same with a whole line, which says its place.
    void add_line(std::string_view kind, const std::string& line);
    /// Whether further warnings of the kind are counted and not shown: their text need not be thought about.
    [[nodiscard]] bool has_enough_of(std::string_view kind) const;
    [[nodiscard]] bool empty() const {
        return kinds_.empty();
    }

    /// All lines, those of a kind together, the kinds in the order in which they came.
    [[nodiscard]] std::vector<std::string> lines() const;

private:
    static constexpr std::size_t kMost = 10;  ///< lines of a kind
    struct Kind {
        std::string name;
        std::vector<std::string> lines;
        std::size_t count = 0;
    };

    const ObjText& text_;
    std::vector<Kind> kinds_;
};

/// 'token', cut where it is long, control characters made visible.
[[nodiscard]] std::string token_in_quotes(std::string_view token);

/// Letters of ASCII alone.
[[nodiscard]] std::string in_lower_case(std::string_view word);

/// Walks over the text, statement by statement. A statement ends with its line, but a backslash at the end of
/// the line joins the next one to it.
class ObjCursor {
public:
    explicit ObjCursor(const ObjText& text) : ObjCursor(text, 0, text.text.size()) {}
    /// Over a part of the text that begins and ends with a line.
    ObjCursor(const ObjText& text, std::size_t begin, std::size_t end) : text_(text), position_(begin), end_(end) {}

    [[nodiscard]] bool at_end() const {
        return position_ >= end_;
    }
    [[nodiscard]] std::size_t offset() const {
        return position_;
    }

    /// The next word of this statement, "" at its end.
    std::string_view next_token();
    /// As next_token, but `#` starts a comment: for statements of numbers, where it cannot be part of a name. Behind a
    /// point it is part of the number: Windows writes what is not a number as -1.#IND.
    std::string_view next_number_token();
    /// The next word, where it is a plain number within float's range; false, and nothing is read: it is not.
    [[nodiscard]] bool take_number(double& number);
    /// From the next word on.
    [[nodiscard]] std::string_view rest_of_text();
    /// Go on behind a word of rest_of_text() that ends at p; false, and nothing is read: no word ends there.
    [[nodiscard]] bool take_up_to(const char* p);
    /// What is left of the statement, blanks at both ends removed, continuations turned into blanks.
    std::string rest_of_statement();
    /// To the first byte of the next statement. A comment ends with its line, backslash or not.
    void skip_statement();
    /// To the first byte of the next line.
    void skip_line();
    /// The place of a token that this cursor returned.
    [[nodiscard]] std::size_t offset_of(std::string_view token) const {
        return static_cast<std::size_t>(token.data() - text_.text.data());
    }
    [[noreturn]] void fail(std::string_view token, const std::string& message) const;

private:
    void skip_blanks();
    [[nodiscard]] char at(std::size_t i) const {
        return i < text_.text.size() ? text_.text[i] : '\n';
    }
    [[nodiscard]] bool continues(std::size_t i) const;
    [[nodiscard]] bool ends_token(std::size_t i) const;

    const ObjText& text_;
    std::size_t position_ = 0;
    std::size_t end_ = 0;
};

/// A finite number within float's range. `what` names it in the message: "an x coordinate".
double parse_finite(const ObjCursor& cursor, std::string_view token, const char* what);

}  // namespace kreda::scene
