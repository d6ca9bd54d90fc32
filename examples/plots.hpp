// Plots of an example: numbers as CSV, drawn by gnuplot.
#pragma once

#include <string>

#include "examples/example.hpp"
#include "tools/draw/plot.hpp"

namespace kreda::examples {

using tools::AxisRange, tools::curve, tools::Plot, tools::Series;

/// A plot without series; what its axes show, with units.
[[nodiscard]] Plot empty_plot(std::string x, std::string y, bool log_x = false, bool log_y = false);

/// Write OUT/NN_name/<name>.csv and .svg, and return the plot as a panel of this size. Without gnuplot the panel says
/// so and only the CSV file is written.
[[nodiscard]] Panel plot_panel(const Options& options, const std::string& name, const std::string& title,
                               const Plot& plot, glm::ivec2 size);

/// Write OUT/NN_name/<name>.csv, .svg and, as large as all pictures, .png. Without gnuplot a line on stderr says so and
/// only the CSV file is written.
void save_plot(const Options& options, const std::string& name, const std::string& title, const Plot& plot);

}  // namespace kreda::examples
