// A table on a panel: a name and up to four numbers a row.
#pragma once

#include <array>
#include <string>

#include <glm/vec4.hpp>

#include "examples/panel.hpp"

namespace kreda::examples {

using NumberRow = std::array<std::string, 5>;  ///< a name and numbers, "" where there is none

/// The first `count` components of p, three places after the point.
[[nodiscard]] NumberRow number_row(const char* name, glm::vec4 p, int count);

/// Write the cells on the panel, a column each, numbers flush right; `baseline` and `size` are in pixels.
void add_row(Panel& table, const NumberRow& cells, float baseline, float size, const glm::vec3& color);

}  // namespace kreda::examples
