// What an experiment leaves: a table, a plot of it, and what is seen, in words whose numbers come from the table.
#pragma once

#include <string>
#include <vector>

#include "tools/draw/plot.hpp"

namespace kreda::tools {

/// Every row has a cell for each column.
struct ResultTable {
    std::vector<std::string> columns;  ///< names with their units: "time [ms]"
    std::vector<std::vector<std::string>> rows;

    void add(std::vector<std::string> row) {
        rows.push_back(std::move(row));
    }
};

/// Six digits.
[[nodiscard]] std::string digits(double number);

/// A number with so many places after the point, for sentences.
[[nodiscard]] std::string fixed(double number, int places);

/// The table as RFC 4180 has it, a line a row, the first of the names; and the other way round.
[[nodiscard]] std::string csv_of(const ResultTable& table);
[[nodiscard]] ResultTable table_of_csv(const std::string& csv);

struct Finding {
    ResultTable table;
    Plot plot;
    std::string text;  ///< one paragraph
};

}  // namespace kreda::tools
