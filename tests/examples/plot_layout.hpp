// Where the texts, the legend and the curves of a plot lie, as gnuplot's SVG file has them, and what is wrong with
// that.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "layout.hpp"

namespace kreda::tests {

struct PlottedCurve {
    std::string name;
    std::vector<glm::vec2> points;   ///< joined by lines, pixels, y down
    std::vector<glm::vec2> markers;  ///< where its markers are
};

struct PlotLayout {
    std::vector<PlacedText> texts;  ///< boxes are estimates: widths of the letters as tools/draw sets them
    std::vector<PlottedCurve> curves;
    std::optional<PlacedText> legend;  ///< its box; nothing of a plot is seen behind it
};

/// `name` is what faults call the picture. An SVG that gnuplot did not write has no texts.
[[nodiscard]] PlotLayout read_plot_layout(const std::string& name, const std::string& svg);

/// A sentence for each text that leaves the plot, is smaller than `least_type` or lies over another one, and for each
/// curve that the legend hides a part of.
[[nodiscard]] std::vector<std::string> plot_faults(const PlotLayout& plot, float least_type);

}  // namespace kreda::tests
