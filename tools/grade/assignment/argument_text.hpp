// Arguments of a call as a teacher reads them: numbers, and words where a number stands for one.
#pragma once

#include <string>

#include "tools/grade/assignment/stage_table.hpp"

namespace kreda::tools {

using NumberText = std::string (*)(double);

/// "(0.1, 0.2, 0.3)", or the number alone where there is one.
[[nodiscard]] std::string numbers_text(const double* values, std::size_t count, NumberText number);

/// Those of a row, "n = (0, 1, 0), light = spot, cos_inner_outer = (0.95, 0.9)"; lists that all rows share are left
/// out.
[[nodiscard]] std::string arguments_text(const StageTable& input, std::size_t row, NumberText number);

}  // namespace kreda::tools
