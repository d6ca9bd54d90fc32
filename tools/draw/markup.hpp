// The markup of captions: text, and formulas between dollar signs, as the pages of the course write them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kreda::tools {

enum class Script { none, sub, super };

/// Letters that are set alike.
struct TypeRun {
    std::u32string text;  ///< code points
    bool italic = false;
    Script script = Script::none;
};

/// UTF-8 as code points; what is no UTF-8 becomes U+FFFD, a byte at a time.
[[nodiscard]] std::u32string code_points(std::string_view utf8);

/// "error of $F_{82}$, $1/d^2$": between dollars Latin and small Greek letters are italic; `_` and `^` lower and raise
/// the next letter, or all that stands in braces. Outside nothing has a second meaning, and `\$` is a dollar sign. A
/// formula that is not closed ends with the text.
[[nodiscard]] std::vector<TypeRun> parse_markup(std::string_view markup);

/// The markup that shows a text as it is.
[[nodiscard]] std::string plain_markup(std::string_view text);

}  // namespace kreda::tools
