// The page of all experiments of a folder: plots and tables are in it, so that one file can be put anywhere.
#include <filesystem>

#include "tools/base64.hpp"
#include "tools/grade/plain_text.hpp"
#include "tools/grade/report_style.hpp"
#include "tools/measure/measure.hpp"
#include "tools/page_style.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kShownRows = 60;

std::string table_html(const ResultTable& table) {
    std::string html =
        "<details><summary>" + std::to_string(table.rows.size()) + " rows</summary><div class=\"wide\"><table><tr>";
    for (const std::string& column : table.columns) html += "<th>" + markup_text(column) + "</th>";
    html += "</tr>\n";
    for (std::size_t r = 0; r < table.rows.size() && r < kShownRows; ++r) {
        html += "<tr>";
        for (const std::string& cell : table.rows[r]) html += "<td>" + markup_text(cell) + "</td>";
        html += "</tr>\n";
    }
    html += "</table></div>";
    if (table.rows.size() > kShownRows)
        html += "<p>The first " + std::to_string(kShownRows) + "; the file has all.</p>";
    return html + "</details>\n";
}

std::string article_html(const Experiment& experiment, const fs::path& path) {
    const std::string svg = bytes_of_file(path.string() + ".svg");
    const auto bytes = reinterpret_cast<const unsigned char*>(svg.data());
    std::string html = "<article id=\"" + std::string(experiment.name) + "\"><h3>" + markup_text(experiment.asks) +
                       "</h3>\n<p>" + markup_text(bytes_of_file(path.string() + ".txt")) + "</p>\n";
    if (svg.empty()) {
        html += "<p>No plot: gnuplot was not installed.</p>\n";
    } else {
        html += "<figure style=\"background:#fff\"><img style=\"width:100%\" alt=\"" + markup_text(experiment.asks) +
                "\" src=\"data:image/svg+xml;base64," + base64({bytes, svg.size()}) + "\"></figure>\n";
    }
    return html + table_html(table_of_csv(bytes_of_file(path.string() + ".csv"))) + "</article>\n";
}

}  // namespace

std::string report_page(const std::string& folder) {
    std::string links, articles;
    for (const Experiment& experiment : experiments()) {
        const fs::path path = fs::path(folder) / experiment.name;
        std::error_code none;
        if (!fs::exists(path.string() + ".key", none)) continue;
        const std::string name(experiment.name);
        links += "<a href=\"#" + name + "\">" + name + "</a>\n";
        articles += article_html(experiment, path);
    }
    return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
           "content=\"width=device-width,initial-scale=1\"><title>Speed against accuracy</title>\n<style>" +
           std::string(kPageStyle) + kReportStyle +
           "</style></head>\n<body><header><h1>Speed against accuracy</h1><p>Measured by kreda measure on this "
           "machine: "
           "times belong to it, errors to the formulas.</p></header>\n<nav><div>" +
           links + "</div></nav>\n<main>" + articles + "</main></body></html>\n";
}

}  // namespace kreda::tools
