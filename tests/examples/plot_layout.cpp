#include "plot_layout.hpp"

#include <algorithm>
#include <cstdio>
#include <regex>
#include <sstream>

#include "tools/draw/markup.hpp"
#include "tools/draw/type.hpp"

namespace kreda::tests {

namespace {

/// Letters' ink above and below the baseline, as parts of the size; digits and most letters have nothing below.
constexpr float kAbove = tools::kCapitals, kBelow = 0.05f;

std::string without_tags(const std::string& xml) {
    std::string text = std::regex_replace(xml, std::regex("<[^>]*>"), "");
    for (const auto& [entity, letter] : {std::pair{"&lt;", "<"}, std::pair{"&gt;", ">"}, std::pair{"&amp;", "&"}}) {
        text = std::regex_replace(text, std::regex(entity), letter);
    }
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// A text whose anchor is at `place`; turned by a quarter to the left where gnuplot says 270 degrees.
PlacedText placed(PlacedText t, glm::vec2 place, const std::string& anchor, bool turned) {
    const float width = tools::type_width(tools::plain_markup(t.text), t.size);
    const float before = anchor == "end" ? width : anchor == "middle" ? 0.5f * width : 0.0f;
    const glm::vec2 low(-before, -kAbove * t.size), high(width - before, kBelow * t.size);
    t.left = place.x + (turned ? low.y : low.x);
    t.right = place.x + (turned ? high.y : high.x);
    t.top = place.y + (turned ? -high.x : low.y);
    t.bottom = place.y + (turned ? -low.x : high.y);
    return t;
}

std::vector<PlacedText> texts_of(const PlacedText& plot, const std::string& svg) {
    static const std::regex group(
        R"re(<g transform="translate\(([-\d.]+),([-\d.]+)\)( rotate\(270\))?"[^>]*font-size="([\d.]+)"\s+text-anchor="(\w+)">\s*<text>(.*)</text>)re");
    std::vector<PlacedText> texts;
    for (std::sregex_iterator it(svg.begin(), svg.end(), group), end; it != end; ++it) {
        const std::smatch& m = *it;
        PlacedText t = plot;
        t.size = std::stof(m[4]);
        t.text = without_tags(m[6]);
        if (!t.text.empty()) {
            texts.push_back(placed(t, {std::stof(m[1]), std::stof(m[2])}, m[5].str(), m[3].matched));
        }
    }
    return texts;
}

/// "M1,2 L3,4 ..." and what is more in that attribute.
void add_points(const std::string& path, PlottedCurve& curve) {
    std::istringstream words(path);
    for (std::string word; words >> word;) {
        glm::vec2 p;
        if (std::sscanf(word.c_str(), "%*[ML]%f,%f", &p.x, &p.y) == 2) curve.points.push_back(p);
    }
}

/// "<use ... transform='translate(1,2) ...": markers.
void add_markers(const std::string& part, PlottedCurve& curve) {
    const std::string mark = "<use ";
    for (std::size_t at = part.find(mark); at != std::string::npos; at = part.find(mark, at + 1)) {
        const std::size_t place = part.find("translate(", at);
        glm::vec2 p;
        if (place == std::string::npos || std::sscanf(part.c_str() + place, "translate(%f,%f", &p.x, &p.y) != 2) return;
        curve.markers.push_back(p);
    }
}

/// The curves and markers that gnuplot draws before the legend's ground.
std::vector<PlottedCurve> curves_of(const std::string& svg) {
    std::vector<PlottedCurve> curves;
    const std::string mark = "<g id=\"gnuplot_plot_";
    for (std::size_t at = svg.find(mark); at != std::string::npos;) {
        const std::size_t next = svg.find(mark, at + 1);
        const std::string part = svg.substr(at, next == std::string::npos ? next : next - at);
        PlottedCurve curve;
        std::smatch title;
        if (std::regex_search(part, title, std::regex("<title>(.*?)</title>"))) curve.name = title[1];
        for (std::size_t d = part.find(" d='"); d != std::string::npos; d = part.find(" d='", d + 1)) {
            add_points(part.substr(d + 4, part.find('\'', d + 4) - d - 4), curve);
        }
        add_markers(part, curve);
        curves.push_back(curve);
        at = next;
    }
    return curves;
}

/// The opaque ground of the legend, and where in the file it is; what follows is drawn over it.
std::optional<PlacedText> legend_of(const PlacedText& plot, const std::string& svg, std::size_t& at) {
    const std::string mark = "<polygon fill";
    at = svg.find(mark);
    if (at == std::string::npos) return std::nullopt;
    const std::size_t points = svg.find("points = '", at) + 10;
    std::istringstream words(svg.substr(points, svg.find('\'', points) - points));
    PlacedText box = plot;
    box.text = "legend";
    box.left = box.top = 1e9f;
    for (std::string word; words >> word;) {
        glm::vec2 p;
        if (std::sscanf(word.c_str(), "%f,%f", &p.x, &p.y) != 2) continue;
        box.left = std::min(box.left, p.x);
        box.top = std::min(box.top, p.y);
        box.right = std::max(box.right, p.x);
        box.bottom = std::max(box.bottom, p.y);
    }
    return box;
}

/// Does the way from a to b pass the inside of the box, half a pixel away from its border?
bool passes(const PlacedText& box, glm::vec2 a, glm::vec2 b) {
    constexpr int kSteps = 32;
    for (int i = 0; i <= kSteps; ++i) {
        const glm::vec2 p = a + (b - a) * (static_cast<float>(i) / kSteps);
        if (p.x > box.left + 0.5f && p.x < box.right - 0.5f && p.y > box.top + 0.5f && p.y < box.bottom - 0.5f) {
            return true;
        }
    }
    return false;
}

bool is_hidden(const PlottedCurve& curve, const PlacedText& legend) {
    const auto hides = [&](glm::vec2 p) { return passes(legend, p, p); };
    if (std::any_of(curve.markers.begin(), curve.markers.end(), hides)) return true;
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
        if (passes(legend, curve.points[i - 1], curve.points[i])) return true;
    }
    return false;
}

}  // namespace

PlotLayout read_plot_layout(const std::string& name, const std::string& svg) {
    PlotLayout layout;
    PlacedText plot;
    plot.picture = name;
    std::smatch size;
    const std::string head = svg.substr(0, 400);
    if (!std::regex_search(head, size, std::regex(R"re(width="(\d+)" height="(\d+)")re"))) return layout;
    plot.width = std::stof(size[1]);
    plot.height = std::stof(size[2]);
    std::size_t at = 0;
    layout.legend = legend_of(plot, svg, at);
    layout.texts = texts_of(plot, svg);
    layout.curves = curves_of(svg.substr(0, at));
    return layout;
}

std::vector<std::string> plot_faults(const PlotLayout& plot, float least_type) {
    std::vector<std::string> faults;
    for (const PlacedText& t : plot.texts) {
        if (t.size < 0.999f * least_type) faults.push_back(t.picture + ": '" + t.text + "' is too small");
    }
    for (const std::string& fault : layout_faults(plot.texts)) {
        if (!fault.ends_with("is too small")) faults.push_back(fault);
    }
    for (const PlottedCurve& curve : plot.curves) {
        if (!plot.legend || !is_hidden(curve, *plot.legend)) continue;
        faults.push_back(plot.legend->picture + ": the legend hides a part of '" + curve.name + "'");
    }
    return faults;
}

}  // namespace kreda::tests
