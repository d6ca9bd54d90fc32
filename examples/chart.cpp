#include "examples/chart.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <glm/geometric.hpp>

namespace kreda::examples {

namespace {

constexpr int kCharacter = 6;  ///< width of one at scale 1; its height is 7

double share(const Axis& axis, double value) {
    if (!axis.logarithmic) return (value - axis.from) / (axis.to - axis.from);
    return std::log10(value / axis.from) / std::log10(axis.to / axis.from);
}

double value_at(const Axis& axis, double share_of_axis) {
    if (!axis.logarithmic) return axis.from + share_of_axis * (axis.to - axis.from);
    return axis.from * std::pow(axis.to / axis.from, share_of_axis);
}

std::string number_text(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", number);
    return text;
}

std::vector<double> marks(const Axis& axis) {
    std::vector<double> values;
    if (axis.logarithmic) {
        for (double v = axis.from; v < axis.to * 1.5; v *= 10.0) values.push_back(v);
        return values;
    }
    const int count = static_cast<int>(std::lround((axis.to - axis.from) / axis.step));
    for (int i = 0; i <= count; ++i) values.push_back(axis.from + i * axis.step);
    return values;
}

int width_of(const std::string& text, int scale) {
    return static_cast<int>(text.size()) * kCharacter * scale;
}

void draw_grid(Chart& chart) {
    const glm::vec3 faint = 0.5f * (kSlate + kBoard);
    for (const double value : marks(chart.x)) {
        const std::string text = number_text(value);
        const glm::vec2 foot = chart.place(value, chart.y.from);
        draw_line(chart.image, foot, {foot.x, chart.upper_right.y}, 1.0f, faint);
        const int left = static_cast<int>(foot.x) - (width_of(text, chart.scale) - chart.scale) / 2;
        const int last = chart.image.width - width_of(text, chart.scale);
        draw_text(chart.image, std::min(left, last), static_cast<int>(foot.y) + 3 * chart.scale, text, kDust,
                  chart.scale);
    }
    for (const double value : marks(chart.y)) {
        const std::string text = number_text(value);
        const glm::vec2 foot = chart.place(chart.x.from, value);
        draw_line(chart.image, foot, {chart.upper_right.x, foot.y}, 1.0f, faint);
        const int left = static_cast<int>(foot.x) - width_of(text, chart.scale) - chart.scale;
        draw_text(chart.image, left, static_cast<int>(foot.y) - 3 * chart.scale, text, kDust, chart.scale);
    }
}

/// The part of a segment between two heights of the picture; false if there is none.
bool clip_to_rows(glm::vec2& a, glm::vec2& b, float top, float bottom) {
    const auto clip = [](glm::vec2& inside, glm::vec2& other, float limit, bool below) {
        if (below ? inside.y <= limit : inside.y >= limit) return true;
        if (below ? other.y > limit : other.y < limit) return false;
        inside += (other - inside) * ((limit - inside.y) / (other.y - inside.y));
        return true;
    };
    return clip(a, b, bottom, true) && clip(b, a, bottom, true) && clip(a, b, top, false) && clip(b, a, top, false);
}

}  // namespace

glm::vec2 Chart::place(double x_value, double y_value) const {
    const glm::vec2 shares(share(x, x_value), share(y, y_value));
    return lower_left + shares * (upper_right - lower_left);
}

Chart make_chart(glm::ivec2 size, int picture_height, const std::string& title, const Axis& x, const Axis& y) {
    Chart chart;
    chart.image = make_board(size.x, size.y);
    chart.x = x;
    chart.y = y;
    chart.scale = text_scale(picture_height);
    int widest = 0;
    for (const double value : marks(y)) widest = std::max(widest, width_of(number_text(value), chart.scale));
    const float unit = static_cast<float>(chart.scale);
    chart.lower_left = {static_cast<float>(widest) + 3.0f * unit, static_cast<float>(size.y) - 12.0f * unit};
    chart.upper_right = {static_cast<float>(size.x) - 7.0f * unit, 14.0f * unit};
    draw_grid(chart);
    const glm::vec2 corner = chart.lower_left;
    draw_line(chart.image, corner, {chart.upper_right.x, corner.y}, unit, kDust);
    draw_line(chart.image, corner, {corner.x, chart.upper_right.y}, unit, kDust);
    draw_text(chart.image, static_cast<int>(corner.x), 3 * chart.scale, title, kChalk, chart.scale);
    return chart;
}

void plot(Chart& chart, const glm::vec3& color, const std::function<double(double)>& f, bool dashed) {
    const float width = 1.4f * static_cast<float>(chart.scale);
    const int steps = static_cast<int>(chart.upper_right.x - chart.lower_left.x);
    const int dash = 4 * chart.scale;
    double x = chart.x.from, y = f(x);
    for (int i = 1; i <= steps; ++i) {
        const double next_x = value_at(chart.x, static_cast<double>(i) / steps), next_y = f(next_x);
        glm::vec2 a = chart.place(x, y), b = chart.place(next_x, next_y);
        const bool drawn = !dashed || (i / dash) % 2 == 0;
        const bool finite = std::isfinite(a.y) && std::isfinite(b.y);
        if (drawn && finite && clip_to_rows(a, b, chart.upper_right.y, chart.lower_left.y)) {
            draw_line(chart.image, a, b, width, color);
        }
        x = next_x;
        y = next_y;
    }
}

void plot_points(Chart& chart, const glm::vec3& color, const std::vector<glm::dvec2>& points, bool dashed) {
    const float unit = static_cast<float>(chart.scale);
    const auto inside = [&](glm::vec2 p) { return p.y >= chart.upper_right.y && p.y <= chart.lower_left.y; };
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::vec2 here = chart.place(points[i].x, points[i].y);
        if (inside(here)) draw_disc(chart.image, here, 2.0f * unit, color);
        if (i == 0) continue;
        const glm::vec2 before = chart.place(points[i - 1].x, points[i - 1].y);
        const int pieces = dashed ? std::max(1, static_cast<int>(glm::distance(before, here) / (4.0f * unit))) : 1;
        for (int k = 0; k < pieces; k += 2) {
            const float from = static_cast<float>(k) / static_cast<float>(pieces);
            const float to = static_cast<float>(k + 1) / static_cast<float>(pieces);
            glm::vec2 a = before + (here - before) * from, b = before + (here - before) * to;
            if (clip_to_rows(a, b, chart.upper_right.y, chart.lower_left.y)) {
                draw_line(chart.image, a, b, 1.4f * unit, color);
            }
        }
    }
}

void plot_point(Chart& chart, double x, double y, const std::string& name, const glm::vec3& color) {
    const glm::vec2 center = chart.place(x, y);
    draw_disc(chart.image, center, 2.5f * static_cast<float>(chart.scale), color);
    const int width = width_of(name, chart.scale);
    const int right = static_cast<int>(center.x) + 5 * chart.scale;
    const bool room = right + width < static_cast<int>(chart.upper_right.x);
    draw_text(chart.image, room ? right : static_cast<int>(center.x) - width - 4 * chart.scale,
              static_cast<int>(center.y) - 3 * chart.scale, name, color, chart.scale);
}

void legend(Chart& chart, const std::string& text, const glm::vec3& color, glm::vec2 start) {
    const glm::vec2 frame(chart.upper_right.x - chart.lower_left.x, chart.lower_left.y - chart.upper_right.y);
    const int x = static_cast<int>(chart.lower_left.x + start.x * frame.x);
    const int y = static_cast<int>(chart.upper_right.y + start.y * frame.y) + 10 * chart.scale * chart.legends;
    draw_text(chart.image, x, y, text, color, chart.scale);
    ++chart.legends;
}

}  // namespace kreda::examples
