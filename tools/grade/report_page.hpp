// One submission as one page: everything in one file, nothing from the network.
#pragma once

#include <string>

#include "tools/grade/result.hpp"

namespace kreda::tools {

enum class Reader { teacher, student };

/// Failures first. A student's page tells of hidden tests the name and the points alone.
[[nodiscard]] std::string report_html(const GradeResult& result, Reader reader);

/// Head and foot of a page with our style; `title` is plain text.
[[nodiscard]] std::string report_head(const std::string& title);
[[nodiscard]] std::string report_foot();

}  // namespace kreda::tools
