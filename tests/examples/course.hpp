// What the tests of the course read: golden images, docs pages, the numbers quoted in them.
#pragma once

#include <string>
#include <vector>

#include "raster/image.hpp"

namespace kreda::tests {

/// A golden image, "10_triangle/coverage.png". golden_check holds every example to its golden images, so what is true
/// of them is true of what the example draws.
[[nodiscard]] raster::Image golden(const std::string& file);

/// Panel number `index` (row by row) of a golden montage of 320 x 180, decoded to linear light.
[[nodiscard]] raster::Image linear_panel(const std::string& file, int columns, int rows, int index);

/// Names of all examples, "10_triangle", sorted.
[[nodiscard]] std::vector<std::string> example_names();

/// A text file of the repository; fails the test if it is not there.
[[nodiscard]] std::string repository_text(const std::string& path);

/// The number that docs/NAME.md quotes and marks on the same line with <!-- number: KEY = VALUE -->.
[[nodiscard]] double documented_number(const std::string& example, const std::string& key);

}  // namespace kreda::tests
