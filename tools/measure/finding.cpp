#include "tools/measure/finding.hpp"

#include <cstdio>

namespace kreda::tools {

namespace {

std::string quoted(const std::string& cell) {
    if (cell.find_first_of(",\"\n\r") == std::string::npos) return cell;
    std::string text = "\"";
    for (const char c : cell) text += c == '"' ? std::string("\"\"") : std::string(1, c);
    return text + "\"";
}

std::string line_of(const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) line += (i > 0 ? "," : "") + quoted(cells[i]);
    return line + "\n";
}

}  // namespace

std::string digits(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", number);
    return text;
}

std::string fixed(double number, int places) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", places, number);
    return text;
}

std::string csv_of(const ResultTable& table) {
    std::string csv = line_of(table.columns);
    for (const std::vector<std::string>& row : table.rows) csv += line_of(row);
    return csv;
}

ResultTable table_of_csv(const std::string& csv) {
    std::vector<std::vector<std::string>> lines;
    std::vector<std::string> cells(1);
    bool in_quotes = false;
    for (std::size_t i = 0; i < csv.size(); ++i) {
        const char c = csv[i];
        if (c == '"' && in_quotes && i + 1 < csv.size() && csv[i + 1] == '"') {
            cells.back() += csv[++i];
        } else if (c == '"') {
            in_quotes = !in_quotes;
        } else if (c == ',' && !in_quotes) {
            cells.emplace_back();
        } else if (c == '\n' && !in_quotes) {
            lines.push_back(std::move(cells));
            cells.assign(1, "");
        } else {
            cells.back() += c;
        }
    }
    if (lines.empty()) return {};
    return {lines.front(), {lines.begin() + 1, lines.end()}};
}

}  // namespace kreda::tools
