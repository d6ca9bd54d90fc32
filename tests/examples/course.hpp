// What the tests of the course read: golden images, docs pages, the numbers quoted in them.
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "raster/image.hpp"

namespace kreda::tests {

/// A golden panel, "10_triangle/coverage.png". golden_check holds every example to its golden panels, so what is true
/// of them is true of what the example draws.
[[nodiscard]] raster::Image golden(const std::string& file);

/// The golden panels of a picture of 320 x 180, "13_perspective/compare", in their places; without the captions.
[[nodiscard]] raster::Image golden_montage(const std::string& picture, int columns);

/// Panel number `index` (row by row) of a picture of 320 x 180 in the middle of its cell, decoded to linear light.
[[nodiscard]] raster::Image linear_panel(const std::string& picture, int columns, int rows, int index);

/// The points of a plot's series, from its golden CSV file "40_fresnel/methods".
[[nodiscard]] std::vector<glm::dvec2> golden_series(const std::string& plot, const std::string& series);

/// y of the point of a series whose x is this; fails the test if there is none.
[[nodiscard]] double golden_value(const std::string& plot, const std::string& series, double x);

/// Names of all examples, "10_triangle", sorted.
[[nodiscard]] std::vector<std::string> example_names();

/// A text file of the repository; fails the test if it is not there.
[[nodiscard]] std::string repository_text(const std::string& path);

/// The number that docs/NAME.md quotes and marks on the same line with <!-- number: KEY = VALUE -->.
[[nodiscard]] double documented_number(const std::string& example, const std::string& key);

/// A number as a page writes it: "0.98" is 0.98, and one step of its last digit is 0.01; "1.8e-7" has steps of 0.1e-7.
struct QuotedNumber {
    double value = 0.0;
    double step = 1.0;
};

/// Does the number, rounded to the digits that the page shows, give what the page shows?
[[nodiscard]] bool rounds_to(double number, const QuotedNumber& quoted);

/// All numbers of a text, "12.1 %, 4" has two. Marks in <!-- --> and the digits of names such as F82 do not count.
[[nodiscard]] std::vector<QuotedNumber> numbers_in(const std::string& text);

/// The same number as documented_number(), with its digits.
[[nodiscard]] QuotedNumber quoted_number(const std::string& example, const std::string& key);

/// The numbers of one row of a table in docs/NAME.md, from left to right without the first cell. The table is the first
/// one whose heading holds `heading`; of its rows the one whose first cell is `row`.
[[nodiscard]] std::vector<QuotedNumber> documented_row(const std::string& example, const std::string& heading,
                                                       const std::string& row);

}  // namespace kreda::tests
