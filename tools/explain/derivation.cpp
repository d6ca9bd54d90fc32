#include "tools/explain/derivation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

namespace kreda::tools {

namespace {

constexpr std::size_t kLineWidth = 110;

/// Characters that are seen: bytes that continue a UTF-8 character do not count.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](unsigned char c) { return (c & 0xc0u) != 0x80u; }));
}

std::string padded(const std::string& text, std::size_t width) {
    const std::size_t seen = width_of(text);
    return seen < width ? text + std::string(width - seen, ' ') : text;
}

std::string value_text(const std::vector<double>& value) {
    if (value.size() == 1) return number_text(value[0]);
    std::string text = "(";
    for (std::size_t i = 0; i < value.size(); ++i) text += (i ? ", " : "") + number_text(value[i]);
    return text + ")";
}

/// What stands behind the equals signs, one after another: formula, numbers, result with its remark.
std::vector<std::string> right_sides(const Equation& equation) {
    std::vector<std::string> sides;
    if (!equation.formula.empty()) sides.push_back(equation.formula);
    if (!equation.numbers.empty()) sides.push_back(equation.numbers);
    if (!equation.value.empty()) {
        const std::string result = value_text(equation.value);
        if (sides.empty() || sides.back() != result) sides.push_back(result);
    }
    if (!equation.note.empty() && !sides.empty()) sides.back() += "   " + equation.note;
    return sides;
}

void write_equation(const Equation& equation, std::string& text) {
    constexpr std::size_t kSymbolWidth = 10;
    const std::vector<std::string> sides = right_sides(equation);
    std::string line = "  " + padded(equation.symbol, kSymbolWidth);
    const std::size_t indent = width_of(line);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (i > 0 && width_of(line) + width_of(sides[i]) + 3 > kLineWidth) {
            text += line + "\n";
            line = std::string(indent, ' ');
        }
        line += " = " + sides[i];
    }
    text += line + "\n";
}

void write_wrapped(const std::string& sentence, std::string& text) {
    std::string line = "  ";
    std::size_t begin = 0;
    while (begin < sentence.size()) {
        const std::size_t end = std::min(sentence.find(' ', begin), sentence.size());
        const std::string word = sentence.substr(begin, end - begin);
        if (width_of(line) + width_of(word) > kLineWidth && line.size() > 2) {
            while (line.back() == ' ') line.pop_back();
            text += line + "\n";
            line = "  ";
        }
        line += word + " ";
        begin = end + 1;
    }
    while (!line.empty() && line.back() == ' ') line.pop_back();
    text += line + "\n";
}

void write_table(const Table& table, std::string& text) {
    std::vector<std::size_t> width;
    const auto measure = [&](const std::vector<std::string>& cells) {
        width.resize(std::max(width.size(), cells.size()));
        for (std::size_t i = 0; i < cells.size(); ++i) width[i] = std::max(width[i], width_of(cells[i]));
    };
    measure(table.head);
    for (const auto& row : table.rows) measure(row);
    const auto write = [&](const std::vector<std::string>& cells) {
        std::string line = "  ";
        for (std::size_t i = 0; i < cells.size(); ++i) line += padded(cells[i], width[i] + 2);
        while (!line.empty() && line.back() == ' ') line.pop_back();
        text += line + "\n";
    };
    if (!table.head.empty()) write(table.head);
    for (const auto& row : table.rows) write(row);
}

// ---------------------------------------------------------------------------------------------------- Markdown

/// A cell of a Markdown table, as code so that no * or _ is taken for markup.
std::string cell_text(const std::string& text) {
    if (text.empty()) return "";
    std::string escaped;
    for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
    return "`" + escaped + "`";
}

void write_markdown_row(const std::vector<std::string>& cells, bool code, std::string& text) {
    text += "|";
    for (const std::string& cell : cells) text += " " + (code ? cell_text(cell) : cell) + " |";
    text += "\n";
}

void write_markdown_head(const std::vector<std::string>& head, std::string& text) {
    write_markdown_row(head, false, text);
    text += "|";
    for (std::size_t i = 0; i < head.size(); ++i) text += " --- |";
    text += "\n";
}

void write_markdown_items(const Section& section, std::string& text) {
    bool in_equations = false;
    for (const Item& item : section.items) {
        const auto* equation = std::get_if<Equation>(&item);
        if (!equation) text += in_equations ? "\n" : "";
        if (equation) {
            if (!in_equations) write_markdown_head({"symbol", "formula", "numbers", "result"}, text);
            const std::string result = value_text(equation->value);
            write_markdown_row({cell_text(equation->symbol), cell_text(equation->formula), cell_text(equation->numbers),
                                (equation->value.empty() ? "" : cell_text(result)) +
                                    (equation->note.empty() ? "" : " " + equation->note)},
                               false, text);
        } else if (const auto* sentence = std::get_if<std::string>(&item)) {
            text += *sentence + "\n\n";
        } else if (const auto* table = std::get_if<Table>(&item)) {
            const std::size_t columns = table->rows.empty() ? table->head.size() : table->rows[0].size();
            write_markdown_head(table->head.empty() ? std::vector<std::string>(columns, " ") : table->head, text);
            for (const auto& row : table->rows) write_markdown_row(row, true, text);
            text += "\n";
        }
        in_equations = equation != nullptr;
    }
    if (in_equations) text += "\n";
}

// -------------------------------------------------------------------------------------------------------- JSON

nlohmann::ordered_json json_of(const Equation& equation) {
    nlohmann::ordered_json json = {{"symbol", equation.symbol}};
    if (!equation.formula.empty()) json["formula"] = equation.formula;
    if (!equation.numbers.empty()) json["numbers"] = equation.numbers;
    if (equation.value.size() == 1) json["value"] = equation.value[0];
    if (equation.value.size() > 1) json["value"] = equation.value;
    if (!equation.note.empty()) json["note"] = equation.note;
    return json;
}

nlohmann::ordered_json json_of(const Table& table) {
    nlohmann::ordered_json json = {{"table", table.name}};
    if (!table.head.empty()) json["head"] = table.head;
    json["rows"] = table.rows;
    return json;
}

nlohmann::ordered_json json_of(const Section& section) {
    nlohmann::ordered_json items = nlohmann::ordered_json::array();
    for (const Item& item : section.items) {
        if (const auto* sentence = std::get_if<std::string>(&item)) items.push_back({{"text", *sentence}});
        if (const auto* equation = std::get_if<Equation>(&item)) items.push_back(json_of(*equation));
        if (const auto* table = std::get_if<Table>(&item)) items.push_back(json_of(*table));
    }
    return {{"id", section.id}, {"title", section.title}, {"items", items}};
}

template <int N>
std::string components_text(const glm::vec<N, float>& v) {
    std::vector<double> value;
    for (int i = 0; i < N; ++i) value.push_back(v[i]);
    return value_text(value);
}

}  // namespace

std::string number_text(double value) {
    if (std::isnan(value)) return "not a number";
    if (std::isinf(value)) return value > 0.0 ? "infinity" : "-infinity";
    constexpr double kExactInteger = 9007199254740992.0;  // 2^53
    const bool whole = std::trunc(value) == value && std::abs(value) < kExactInteger;
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, whole ? "%.0f" : "%.6g", value == 0.0 ? 0.0 : value);
    return buffer;
}

std::string vector_text(const glm::vec2& v) {
    return components_text(v);
}

std::string vector_text(const glm::vec3& v) {
    return components_text(v);
}

std::string vector_text(const glm::vec4& v) {
    return components_text(v);
}

std::string factor_text(double value) {
    return value < 0.0 ? "(" + number_text(value) + ")" : number_text(value);
}

std::string dot_text(const glm::vec3& a, const glm::vec3& b) {
    std::string text;
    for (int i = 0; i < 3; ++i) text += (i ? " + " : "") + factor_text(a[i]) + "·" + factor_text(b[i]);
    return text;
}

std::string as_text(const Derivation& derivation) {
    std::string text = derivation.title + "\n";
    int number = 1;
    for (const Section& section : derivation.sections) {
        text += "\n" + std::to_string(number++) + ". " + section.title + "\n";
        for (const Item& item : section.items) {
            if (const auto* sentence = std::get_if<std::string>(&item)) write_wrapped(*sentence, text);
            if (const auto* equation = std::get_if<Equation>(&item)) write_equation(*equation, text);
            if (const auto* table = std::get_if<Table>(&item)) write_table(*table, text);
            const bool last = &item == &section.items.back();
            if (std::holds_alternative<Table>(item) && !last) text += "\n";
        }
    }
    return text;
}

std::string as_markdown(const Derivation& derivation) {
    std::string text = "# " + derivation.title + "\n";
    int number = 1;
    for (const Section& section : derivation.sections) {
        text += "\n## " + std::to_string(number++) + ". " + section.title + "\n\n";
        write_markdown_items(section, text);
    }
    return text;
}

std::string as_json(const Derivation& derivation) {
    nlohmann::ordered_json sections = nlohmann::ordered_json::array();
    for (const Section& section : derivation.sections) sections.push_back(json_of(section));
    return nlohmann::ordered_json{{"title", derivation.title}, {"sections", sections}}.dump(
               2, ' ', false, nlohmann::json::error_handler_t::replace) +
           "\n";
}

}  // namespace kreda::tools
