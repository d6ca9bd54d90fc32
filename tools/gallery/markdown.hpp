// The little Markdown that the pages under docs/ use, as HTML.
#pragma once

#include <functional>
#include <string>

namespace kreda::tools {

/// & < > " become entities.
[[nodiscard]] std::string escape_html(const std::string& text);

/// Where a link or picture of the text points to, seen from the page that is written.
using LinkMap = std::function<std::string(const std::string& target)>;

/// Headings, paragraphs, lists (one level), tables, fenced or indented code, `code`, **bold**, *italic*, links and
/// pictures. Everything else is text. A formula $$...$$ alone on a line is shown as LaTeX. Raw HTML is shown, not
/// obeyed, but for the fold of an answer; comments <!-- --> are left out.
[[nodiscard]] std::string html_from_markdown(const std::string& markdown, const LinkMap& link);

}  // namespace kreda::tools
