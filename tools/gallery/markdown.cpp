#include "tools/gallery/markdown.hpp"

#include <cctype>
#include <sstream>
#include <vector>

namespace kreda::tools {

namespace {

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

const std::string kIndent = "    ";  ///< four spaces before a line: code

bool starts_with(const std::string& text, const std::string& start) {
    return text.rfind(start, 0) == 0;
}

/// The text between `open` at `at` and the next `close`; `end` is the first character after it, or npos.
std::string enclosed(const std::string& text, std::size_t at, const std::string& open, const std::string& close,
                     std::size_t& end) {
    const std::size_t start = at + open.size();
    const std::size_t stop = text.compare(at, open.size(), open) == 0 ? text.find(close, start) : std::string::npos;
    end = stop == std::string::npos || stop == start ? std::string::npos : stop + close.size();
    return end == std::string::npos ? std::string() : text.substr(start, stop - start);
}

std::string inline_html(const std::string& text, const LinkMap& link);

/// [text](target) or ![text](target) at `at`; empty where there is none.
std::string link_html(const std::string& text, std::size_t at, const LinkMap& link, std::size_t& end) {
    const bool picture = text[at] == '!';
    const std::size_t bracket = at + (picture ? 1 : 0);
    std::size_t after_label = 0;
    const std::string label = enclosed(text, bracket, "[", "](", after_label);
    end = std::string::npos;
    if (after_label == std::string::npos) return {};
    const std::string target = enclosed(text, after_label - 1, "(", ")", end);
    if (end == std::string::npos) return {};
    const std::string address = escape_html(link(target));
    if (picture) return "<img src=\"" + address + "\" alt=\"" + escape_html(label) + "\" loading=\"lazy\">";
    return "<a href=\"" + address + "\">" + inline_html(label, link) + "</a>";
}

/// A span that starts at `at`, as HTML, and where it ends; end = npos where none starts.
std::string span_html(const std::string& text, std::size_t at, const LinkMap& link, std::size_t& end) {
    const char c = text[at];
    end = std::string::npos;
    if (c == '`') {
        const std::string code = enclosed(text, at, "`", "`", end);
        return "<code>" + escape_html(code) + "</code>";
    }
    if (c == '*' && text.compare(at, 2, "**") == 0) {
        const std::string bold = enclosed(text, at, "**", "**", end);
        return end == std::string::npos ? std::string() : "<strong>" + inline_html(bold, link) + "</strong>";
    }
    if (c == '*' && at + 1 < text.size() && text[at + 1] != ' ') {  // `a * b` is a product, not italic
        const std::string italic = enclosed(text, at, "*", "*", end);
        return end == std::string::npos ? std::string() : "<em>" + inline_html(italic, link) + "</em>";
    }
    if (c == '<' && text.compare(at, 4, "<!--") == 0) {
        const std::size_t stop = text.find("-->", at + 4);
        if (stop != std::string::npos) end = stop + 3;
        return {};
    }
    if (c == '[' || (c == '!' && at + 1 < text.size() && text[at + 1] == '[')) return link_html(text, at, link, end);
    return {};
}

std::string inline_html(const std::string& text, const LinkMap& link) {
    std::string html;
    std::size_t at = 0;
    while (at < text.size()) {
        std::size_t end = std::string::npos;
        const std::string span = span_html(text, at, link, end);
        const bool is_comment = end != std::string::npos && span.empty();
        if (is_comment && !html.empty() && html.back() == ' ') html.pop_back();
        html += end == std::string::npos ? escape_html(text.substr(at, 1)) : span;
        at = end == std::string::npos ? at + 1 : end;
    }
    return html;
}

/// Number of characters of a list mark ("- ", "* ", "12. "), 0 where the line is no item.
std::size_t list_mark(const std::string& line) {
    if (starts_with(line, "- ") || starts_with(line, "* ")) return 2;
    std::size_t digits = 0;
    while (digits < line.size() && std::isdigit(static_cast<unsigned char>(line[digits]))) ++digits;
    return digits > 0 && line.compare(digits, 2, ". ") == 0 ? digits + 2 : 0;
}

/// The cells of "| a | b |". A pipe inside `code` or after a backslash does not divide.
std::vector<std::string> table_cells(const std::string& line) {
    std::vector<std::string> cells;
    std::string cell;
    bool code = false;
    for (std::size_t i = 1; i < line.size(); ++i) {
        if (line[i] == '`') code = !code;
        if (line[i] == '\\' && i + 1 < line.size() && line[i + 1] == '|') {
            cell += line[++i];
        } else if (line[i] == '|' && !code) {
            cells.push_back(trimmed(cell));
            cell.clear();
        } else {
            cell += line[i];
        }
    }
    if (!trimmed(cell).empty()) cells.push_back(trimmed(cell));
    return cells;
}

bool is_table_rule(const std::string& line) {
    return starts_with(line, "|") && line.find_first_not_of("|-: \t") == std::string::npos;
}

/// <details><summary>Answer</summary> and </details>, each alone on a line, are the only HTML that is obeyed.
const std::string kFold = "<details><summary>Answer</summary>", kFoldEnd = "</details>";

bool is_formula(const std::string& line) {
    return line.size() > 4 && starts_with(line, "$$") && line.compare(line.size() - 2, 2, "$$") == 0;
}

/// Reads the text line by line; each block takes the lines that belong to it.
class Reader {
public:
    Reader(const std::string& markdown, const LinkMap& link) : link_(link) {
        std::istringstream stream(markdown);
        for (std::string line; std::getline(stream, line);) lines_.push_back(line);
    }

    std::string html() {
        while (at_ < lines_.size()) block();
        return html_;
    }

private:
    [[nodiscard]] std::string line() const {
        return at_ < lines_.size() ? trimmed(lines_[at_]) : std::string();
    }

    [[nodiscard]] bool starts_block() const {
        const std::string text = line();
        return text.empty() || starts_with(text, "#") || starts_with(text, "```") || starts_with(text, "|") ||
               text == kFold || text == kFoldEnd || is_formula(text) || list_mark(text) > 0;
    }

    void block() {
        const std::string text = line();
        if (text.empty())
            ++at_;
        else if (starts_with(lines_[at_], kIndent))
            indented_code();
        else if (starts_with(text, "```"))
            code();
        else if (starts_with(text, "#"))
            heading();
        else if (starts_with(text, "|"))
            table();
        else if (text == kFold || text == kFoldEnd)
            html_ += text + "\n", ++at_;
        else if (is_formula(text))
            formula();
        else if (list_mark(text) > 0)
            list();
        else
            paragraph();
    }

    /// A comment alone leaves nothing behind.
    void paragraph() {
        const std::string inside = trimmed(inline_html(joined(0), link_));
        if (!inside.empty()) html_ += "<p>" + inside + "</p>\n";
    }

    /// This line without its first `skip` characters, and the lines that continue it.
    std::string joined(std::size_t skip) {
        std::string text = line().substr(skip);
        for (++at_; !starts_block(); ++at_) text += " " + line();
        return text;
    }

    void heading() {
        const std::string text = line();
        const std::size_t marks = std::min(text.find_first_not_of('#'), text.size());
        const std::string tag = "h" + std::to_string(std::min<std::size_t>(marks, 6));
        html_ += "<" + tag + ">" + inline_html(trimmed(text.substr(marks)), link_) + "</" + tag + ">\n";
        ++at_;
    }

    void code() {
        html_ += "<pre><code>";
        for (++at_; at_ < lines_.size() && !starts_with(line(), "```"); ++at_) html_ += escape_html(lines_[at_]) + "\n";
        html_ += "</code></pre>\n";
        ++at_;
    }

    void indented_code() {
        html_ += "<pre><code>";
        for (; at_ < lines_.size() && starts_with(lines_[at_], kIndent); ++at_) {
            html_ += escape_html(lines_[at_].substr(kIndent.size())) + "\n";
        }
        html_ += "</code></pre>\n";
    }

    /// LaTeX as it is written, without its dollars: `./course docs` makes formulas of them.
    void formula() {
        const std::string text = line();
        html_ += "<pre><code>" + escape_html(text.substr(2, text.size() - 4)) + "</code></pre>\n";
        ++at_;
    }

    void list() {
        const std::string first = line().substr(0, list_mark(line()));  // "- " or "12. "
        const std::string tag = std::isdigit(static_cast<unsigned char>(first[0])) ? "ol" : "ul";
        const std::string number = tag == "ol" ? first.substr(0, first.size() - 2) : "1";
        html_ += "<" + tag + (number == "1" ? "" : " start=\"" + number + "\"") + ">\n";
        while (list_mark(line()) > 0) html_ += "<li>" + inline_html(joined(list_mark(line())), link_) + "</li>\n";
        html_ += "</" + tag + ">\n";
    }

    void table() {
        html_ += "<div class=\"wide\"><table>\n";
        for (bool first = true; starts_with(line(), "|"); ++at_) {
            if (is_table_rule(line())) continue;
            const std::string tag = first ? "th" : "td";
            html_ += "<tr>";
            for (const std::string& cell : table_cells(line())) {
                html_ += "<" + tag + ">" + inline_html(cell, link_) + "</" + tag + ">";
            }
            html_ += "</tr>\n";
            first = false;
        }
        html_ += "</table></div>\n";
    }

    const LinkMap& link_;
    std::vector<std::string> lines_;
    std::size_t at_ = 0;
    std::string html_;
};

}  // namespace

std::string escape_html(const std::string& text) {
    std::string html;
    for (const char c : text) {
        if (c == '&')
            html += "&amp;";
        else if (c == '<')
            html += "&lt;";
        else if (c == '>')
            html += "&gt;";
        else if (c == '"')
            html += "&quot;";
        else
            html += c;
    }
    return html;
}

std::string html_from_markdown(const std::string& markdown, const LinkMap& link) {
    return Reader(markdown, link).html();
}

}  // namespace kreda::tools
