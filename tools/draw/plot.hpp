// What a plot shows, as data: gnuplot draws it (tools/draw/gnuplot.hpp).
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

namespace kreda::tools {

/// Points that belong together. Texts have the markup of tools/draw/markup.hpp.
struct Series {
    std::string name;  ///< in the legend; "": not there
    std::vector<glm::dvec2> points;
    int style = 0;                           ///< number of its colour, dash and marker from 1; 0: its place in the plot
    std::vector<std::string> point_names{};  ///< one beside each point, or none at all
    bool joined = true;                      ///< by lines, where the plot has lines at all
};

/// From the left or lower end of an axis to the other.
struct AxisRange {
    double from = 0.0, to = 1.0;
};

struct Plot {
    std::string x, y;  ///< what the axes show, with units
    bool log_x = false, log_y = false;
    std::vector<Series> series;
    bool lines = true;                   ///< from point to point
    std::optional<AxisRange> x_range{};  ///< without: as wide as the points need
    std::optional<AxisRange> y_range{};
    std::string key{};  ///< gnuplot's words for where the legend is; "": to the right of the plot
};

/// y = f(x) at `count` points, evenly from end to end; on a logarithmic axis evenly in log x.
template <class F>
[[nodiscard]] Series curve(std::string name, AxisRange x, F f, bool log_x = false, int count = 121) {
    Series series{std::move(name), {}};
    for (int i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / (count - 1);
        const double at = log_x ? x.from * std::pow(x.to / x.from, share) : x.from + share * (x.to - x.from);
        series.points.push_back({at, static_cast<double>(f(at))});
    }
    return series;
}

/// Lines "series,x,y", six digits, as RFC 4180 has them.
[[nodiscard]] std::string csv_of(const Plot& plot);

}  // namespace kreda::tools
