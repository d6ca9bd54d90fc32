// Charts on a blackboard: axes with numbers, curves, a legend.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "examples/draw.hpp"

namespace kreda::examples {

/// The numbers an axis runs over, and how far its marks are apart.
struct Axis {
    double from = 0.0, to = 1.0, step = 0.25;
    bool logarithmic = false;  ///< from and to are powers of 10; marks at every one, step is not used
};

struct Chart {
    Image image;
    Axis x, y;
    glm::vec2 lower_left, upper_right;  ///< the frame, in pixels
    int scale = 1;                      ///< of the text
    int legends = 0;                    ///< lines of the legend so far

    /// Where a point of the chart is on the picture.
    [[nodiscard]] glm::vec2 place(double x_value, double y_value) const;
};

/// An empty chart with a title above its frame. `picture_height` is that of the whole picture: it sets the text's size.
[[nodiscard]] Chart make_chart(glm::ivec2 size, int picture_height, const std::string& title, const Axis& x,
                               const Axis& y);

/// The curve y = f(x) over the whole axis; what leaves the frame is cut off. `dashed` draws every other piece.
void plot(Chart& chart, const glm::vec3& color, const std::function<double(double)>& f, bool dashed = false);

/// Straight lines from point to point and a dot at each; what leaves the frame is cut off. `dashed` draws every other
/// piece.
void plot_points(Chart& chart, const glm::vec3& color, const std::vector<glm::dvec2>& points, bool dashed = false);

/// A dot with its name to the right of it (or to the left, where there is no room).
void plot_point(Chart& chart, double x, double y, const std::string& name, const glm::vec3& color);

/// A line of the legend: below the last one, starting at this share of the frame's width and height from upper left.
void legend(Chart& chart, const std::string& text, const glm::vec3& color, glm::vec2 start);

}  // namespace kreda::examples
