// Text of which a student's program may have written a part, made fit for every format.
#pragma once

#include <string>
#include <string_view>

namespace kreda::tools {

/// Valid UTF-8 without control characters but '\n' and '\t' (XML allows no others); what is not becomes '?'. No more
/// than `most` bytes: what is too long is cut and says so.
[[nodiscard]] std::string plain_text(std::string_view text, std::size_t most = 16384);

/// & < > " as entities; for element content and attributes of XML and HTML.
[[nodiscard]] std::string markup_text(std::string_view text);

/// The text up to its first line break.
[[nodiscard]] std::string first_line(std::string_view text);

/// "7.5", "12": at most three decimals, without trailing zeros.
[[nodiscard]] std::string points_text(double points);

}  // namespace kreda::tools
