// The legend of plots that are too small for one of their own.
#pragma once

#include <string>
#include <vector>

#include "examples/example.hpp"

namespace kreda::examples {

/// What the first four styles of tools/draw/plot_style.hpp mean, in their colours and with their markers; four texts at
/// most.
[[nodiscard]] Panel plot_legend(const Options& options, glm::ivec2 size, const std::vector<std::string>& texts);

}  // namespace kreda::examples
