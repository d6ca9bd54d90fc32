// Plots as SVG and PNG, drawn by gnuplot where it is installed.
#pragma once

#include <string>

#include "tools/measure/finding.hpp"

namespace kreda::tools {

[[nodiscard]] bool has_gnuplot();

/// What gnuplot is told to draw the plot into this file: one terminal, "svg" or "pngcairo". Points that a logarithmic
/// axis cannot show are left out.
[[nodiscard]] std::string gnuplot_script(const Plot& plot, const std::string& title, const std::string& terminal,
                                         const std::string& file);

/// Draw `path`.svg and `path`.png. Returns false, and leaves neither, where gnuplot is absent or fails.
[[nodiscard]] bool draw_plot(const Plot& plot, const std::string& title, const std::string& path);

}  // namespace kreda::tools
