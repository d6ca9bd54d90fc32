// Plots as SVG and PNG, drawn by gnuplot where it is installed.
#pragma once

#include <string>

#include <glm/vec2.hpp>

#include "tools/draw/plot.hpp"
#include "tools/draw/theme.hpp"

namespace kreda::tools {

[[nodiscard]] bool has_gnuplot();

/// Let gnuplot do what the script says; what it prints is thrown away. False where it is absent or fails.
[[nodiscard]] bool run_gnuplot(const std::string& script);

/// A text between single quotes, as gnuplot reads it, in one line.
[[nodiscard]] std::string in_gnuplot_quotes(const std::string& text);

/// How a plot is drawn; the size of its letters follows from that of the picture.
struct PlotLook {
    glm::ivec2 size{900, 540};  ///< pixels
    float type_size = 16.0f;    ///< of the letters' em square, in pixels
    Theme theme = Theme::light;
};

/// What gnuplot is told to draw the plot as `path`.svg and `path`.png: data, the one style of all plots, the plot.
/// Points that a logarithmic axis cannot show are left out. Empty when nothing can be shown.
[[nodiscard]] std::string gnuplot_script(const Plot& plot, const std::string& title, const std::string& path,
                                         const PlotLook& look = {});

/// A text with the markup of tools/draw/markup.hpp, or without any, as gnuplot's enhanced mode writes it.
[[nodiscard]] std::string enhanced_text(const std::string& markup);

/// Draw `path`.svg and `path`.png. Returns false, and leaves neither, where gnuplot is absent or fails.
[[nodiscard]] bool draw_plot(const Plot& plot, const std::string& title, const std::string& path,
                             const PlotLook& look = {});

}  // namespace kreda::tools
