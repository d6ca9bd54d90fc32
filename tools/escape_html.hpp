// Text on a page for a browser.
#pragma once

#include <string>

namespace kreda::tools {

/// & < > " become entities.
[[nodiscard]] std::string escape_html(const std::string& text);

}  // namespace kreda::tools
