#include "tools/draw/gnuplot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>

#include <unistd.h>

#include "tools/draw/markup.hpp"
#include "tools/draw/plot_style.hpp"
#include "tools/shell_quotes.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

constexpr std::size_t kMarkers = 8;  ///< of a curve with many points: enough to tell it from others

/// Six digits.
std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string quoted(const std::string& markup) {
    return in_gnuplot_quotes(enhanced_text(markup));
}

std::string utf8(char32_t c) {
    if (c < 0x80) return {static_cast<char>(c)};
    const auto tail = [c](int shift) { return static_cast<char>(0x80u | (c >> shift & 0x3fu)); };
    if (c < 0x800) return {static_cast<char>(0xc0u | c >> 6), tail(0)};
    if (c < 0x10000) return {static_cast<char>(0xe0u | c >> 12), tail(6), tail(0)};
    return {static_cast<char>(0xf0u | c >> 18), tail(12), tail(6), tail(0)};
}

bool can_be_shown(const Plot& plot, const glm::dvec2& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && (!plot.log_x || p.x > 0.0) && (!plot.log_y || p.y > 0.0);
}

/// A table that the script carries with it; the third column is the point's name.
std::string data_block(const Plot& plot, std::size_t s) {
    const Series& series = plot.series[s];
    std::string text = "$s" + std::to_string(s) + " << EOD\n";
    for (std::size_t i = 0; i < series.points.size(); ++i) {
        const glm::dvec2& p = series.points[i];
        if (!can_be_shown(plot, p)) continue;
        text += number(p.x) + " " + number(p.y);
        if (i < series.point_names.size()) text += " \"" + enhanced_text(series.point_names[i]) + "\"";
        text += "\n";
    }
    return text + "EOD\n";
}

/// Series without a point that can be shown are not drawn: gnuplot would complain.
bool is_empty(const Plot& plot, const Series& series) {
    return std::none_of(series.points.begin(), series.points.end(),
                        [&](const glm::dvec2& p) { return can_be_shown(plot, p); });
}

/// What the command `plot` says of one series.
std::string plotted(const Plot& plot, std::size_t s) {
    const Series& series = plot.series[s];
    const std::string type = std::to_string(series.style > 0 ? series.style : static_cast<int>(s) + 1);
    const std::string title = series.name.empty() ? " notitle" : " title " + quoted(series.name);
    const std::string data = "$s" + std::to_string(s);
    std::string text = data + " using 1:2 with ";
    if (plot.lines && series.joined) {
        const std::size_t interval = std::max<std::size_t>(1, series.points.size() / kMarkers);
        text += "linespoints linetype " + type + " pointinterval " + std::to_string(interval) + title;
    } else {
        text += "points linetype " + type + title;
    }
    if (series.point_names.empty()) return text;
    return text + ", " + data + " using 1:2:3 with labels left offset 0.8,0.7 textcolor rgb ink notitle";
}

/// The least of 1, 2, 5 times a power of 10 that makes no more than `most` steps.
double tic_step(const AxisRange& range, double most) {
    const double least = (range.to - range.from) / std::max(most, 1.0);
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double times : {1.0, 2.0, 5.0}) {
        if (times * power >= least * 0.9999) return times * power;
    }
    return 10.0 * power;
}

/// The range of an axis, its kind, and numbers that have room: `most` of them.
std::string axis(const char* name, const std::optional<AxisRange>& range, bool logarithmic, double most) {
    std::string text;
    if (logarithmic) text += std::string("set logscale ") + name + "\nset format " + name + " '10^{%T}'\n";
    if (!range) return text;
    text += std::string("set ") + name + "range [" + number(range->from) + ":" + number(range->to) + "]\n";
    if (logarithmic) {
        const double decades = std::log10(range->to / range->from), step = std::ceil(decades / std::max(most, 1.0));
        return step > 1.0 ? text + "set " + name + "tics 1e" + number(step) + "\n" : text;
    }
    return text + "set " + name + "tics " + number(tic_step(*range, most)) + "\n";
}

std::string terminal(const char* name, const PlotLook& look) {
    std::ostringstream text;
    // Cairo takes a point for 4/3 pixels, SVG for one.
    const bool cairo = std::string(name) == "pngcairo";
    text << "set terminal " << name << " enhanced size " << look.size.x << "," << look.size.y << " font 'DejaVu Sans,"
         << (cairo ? 0.75f : 1.0f) * look.type_size << "' background rgb paper"
         << (cairo ? " linewidth " + number(look.type_size / 20.0) : std::string()) << "\n";
    return text.str();
}

std::string settings(const Plot& plot, const std::string& title, const PlotLook& look) {
    std::string text =
        "set title " + quoted(title) + "\nset xlabel " + quoted(plot.x) + "\nset ylabel " + quoted(plot.y) + "\n";
    if (!plot.x_range || !plot.y_range) text += "set offsets graph 0.02, graph 0.02, graph 0.02, graph 0.02\n";
    // Markers grow with the letters: one that tells a curve from others does so from the last row, too.
    text += "set for [i=1:8] linetype i pointsize " + number(std::max(0.9, look.type_size / 16.0)) + "\n";
    // A number is about three letters wide, and as much stays free beside it.
    const double wide = look.size.x / (6.0 * look.type_size), high = look.size.y / (4.0 * look.type_size);
    return text + axis("x", plot.x_range, plot.log_x, wide) + axis("y", plot.y_range, plot.log_y, high) + "set key " +
           (plot.key.empty() ? "outside right" : plot.key) + " opaque fillcolor rgb paper\n";
}

}  // namespace

std::string in_gnuplot_quotes(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c == '\n' ? ' ' : c);
    return quoted + "'";
}

bool has_gnuplot() {
    return std::system("command -v gnuplot >/dev/null 2>&1") == 0;
}

bool run_gnuplot(const std::string& script) {
    std::string path = (std::filesystem::temp_directory_path() / "kreda-plot-XXXXXX").string();
    const int file = mkstemp(path.data());
    if (file < 0) return false;
    close(file);
    write_file(path, script);  // not through a pipe: writing to a gnuplot that is absent would end this process
    const bool drawn = std::system(("gnuplot " + in_shell_quotes(path) + " >/dev/null 2>&1").c_str()) == 0;
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
    return drawn;
}

std::string enhanced_text(const std::string& markup) {
    std::string text;
    for (const TypeRun& run : parse_markup(markup)) {
        std::string letters;
        for (const char32_t c : run.text) {
            const bool is_special =
                c < 0x80 && std::string("_^{}@&~\\").find(static_cast<char>(c)) != std::string::npos;
            letters += (is_special ? "\\" : "") + utf8(c);
        }
        if (run.italic) letters = "{/:Italic " + letters + "}";
        if (run.script != Script::none) letters = (run.script == Script::sub ? "_{" : "^{") + letters + "}";
        text += letters;
    }
    return text;
}

std::string csv_of(const Plot& plot) {
    std::string text = "series,x,y\n";
    for (const Series& series : plot.series) {
        std::string name;
        for (const char c : series.name) name += c == '"' ? std::string("\"\"") : std::string(1, c);
        if (name.find_first_of(",\"\n") != std::string::npos) name = "\"" + name + "\"";
        for (const glm::dvec2& p : series.points) text += name + "," + number(p.x) + "," + number(p.y) + "\n";
    }
    return text;
}

std::string gnuplot_script(const Plot& plot, const std::string& title, const std::string& path, const PlotLook& look) {
    std::string series;
    for (std::size_t s = 0; s < plot.series.size(); ++s) {
        if (!is_empty(plot, plot.series[s])) series += (series.empty() ? "" : ", \\\n  ") + plotted(plot, s);
    }
    if (series.empty()) return "";
    std::string text;
    for (std::size_t s = 0; s < plot.series.size(); ++s) text += data_block(plot, s);
    text += look.theme == Theme::dark ? kDarkPlot : kLightPlot;
    text += kPlotStyle + settings(plot, title, look);
    for (const auto& [name, ending] : {std::pair{"svg", ".svg"}, std::pair{"pngcairo", ".png"}}) {
        text += terminal(name, look) + "set output " + in_gnuplot_quotes(path + ending) + "\nplot " + series +
                "\nset output\n";
    }
    return text;
}

bool draw_plot(const Plot& plot, const std::string& title, const std::string& path, const PlotLook& look) {
    const std::string script = gnuplot_script(plot, title, path, look);
    if (!script.empty() && has_gnuplot() && run_gnuplot(script)) return true;
    std::error_code ignored;
    for (const char* ending : {".svg", ".png"}) std::filesystem::remove(path + ending, ignored);
    return false;
}

}  // namespace kreda::tools
