#include "tools/measure/gnuplot.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace kreda::tools {

namespace {

/// Between single quotes, as gnuplot reads it.
std::string in_gnuplot_quotes(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c == '\n' ? ' ' : c);
    return quoted + "'";
}

bool can_be_shown(const Plot& plot, const glm::dvec2& p) {
    return (!plot.log_x || p.x > 0.0) && (!plot.log_y || p.y > 0.0);
}

/// A table of numbers that the script carries with it.
std::string data_block(const Plot& plot, std::size_t s) {
    std::string text = "$s" + std::to_string(s) + " << EOD\n";
    for (const glm::dvec2& p : plot.series[s].points) {
        if (can_be_shown(plot, p)) text += digits(p.x) + " " + digits(p.y) + "\n";
    }
    return text + "EOD\n";
}

/// Series without a point that can be shown are not drawn: gnuplot would complain.
bool is_empty(const Plot& plot, const Series& series) {
    for (const glm::dvec2& p : series.points) {
        if (can_be_shown(plot, p)) return false;
    }
    return true;
}

bool run_gnuplot(const std::string& script) {
    std::FILE* pipe = popen("gnuplot >/dev/null 2>&1", "w");
    if (!pipe) return false;
    const bool written = std::fwrite(script.data(), 1, script.size(), pipe) == script.size();
    return pclose(pipe) == 0 && written;
}

}  // namespace

bool has_gnuplot() {
    return std::system("command -v gnuplot >/dev/null 2>&1") == 0;
}

std::string gnuplot_script(const Plot& plot, const std::string& title, const std::string& terminal,
                           const std::string& file) {
    std::string text;
    for (std::size_t s = 0; s < plot.series.size(); ++s) text += data_block(plot, s);
    text += "set terminal " + terminal + " noenhanced size 900,540\nset output " + in_gnuplot_quotes(file) + "\n";
    text += "set title " + in_gnuplot_quotes(title) + "\nset xlabel " + in_gnuplot_quotes(plot.x) + "\nset ylabel " +
            in_gnuplot_quotes(plot.y) + "\n";
    if (plot.log_x) text += "set logscale x\n";
    if (plot.log_y) text += "set logscale y\n";
    text += "set grid\nset key outside right\nset offsets graph 0.02, graph 0.02, graph 0.02, graph 0.02\nplot ";
    bool first = true;
    for (std::size_t s = 0; s < plot.series.size(); ++s) {
        if (is_empty(plot, plot.series[s])) continue;
        text += std::string(first ? "" : ", ") + "$s" + std::to_string(s) + " with " +
                (plot.lines ? "linespoints" : "points") + " pointtype 7 pointsize 0.6 title " +
                in_gnuplot_quotes(plot.series[s].name);
        first = false;
    }
    return first ? std::string() : text + "\n";
}

bool draw_plot(const Plot& plot, const std::string& title, const std::string& path) {
    bool drawn = has_gnuplot();
    for (const auto& [terminal, ending] : {std::pair{"svg", ".svg"}, std::pair{"pngcairo", ".png"}}) {
        const std::string script = gnuplot_script(plot, title, terminal, path + ending);
        drawn = drawn && !script.empty() && run_gnuplot(script);
    }
    if (drawn) return true;
    std::error_code ignored;
    for (const char* ending : {".svg", ".png"}) std::filesystem::remove(path + ending, ignored);
    return false;
}

}  // namespace kreda::tools
