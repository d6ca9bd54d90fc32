// 93_shadow_resolution: size of the map x bias x filter: the error of each against the exact shadow, and its time.
// Page docs/93_shadow_resolution.md | After 67_methods_compared | New: a table of settings, error over size
// Break at: compare_shadows | Look at: error | Try: kBand 0, kLightSize 0.1, table_scene() with its lamp
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <glm/common.hpp>

#include "examples/plots.hpp"
#include "examples/table_scene.hpp"
#include "tools/measure/shadow_settings.hpp"

using namespace kreda;
using namespace kreda::examples;
using namespace kreda::tools;

namespace {

constexpr float kLightSize = 0.02f;  // for pcss
constexpr int kBand = 2;             // samples: errors farther than this from every edge are acne or leaks

const std::array<const char*, 3> kFilters = {"none", "pcf", "pcss"};  // as in kMapFilters
const std::array<const char*, 4> kBiases = {"none", "constant", "slope", "normal"};

double percent(const ShadowRow& row, std::uint64_t count) {
    return 100.0 * static_cast<double>(count) / static_cast<double>(row.error.visible);
}

void print_rows(const std::vector<ShadowRow>& rows) {
    std::printf("filter bias      size   wrong %%    acne %%  edge off/px     rmse       ms\n");
    for (const ShadowRow& row : rows) {
        std::printf("%-6s %-8s %5d %9.3f %9.3f %12.3f %8.4f %8.1f\n", kFilters[row.filter], kBiases[row.bias],
                    kMapSizes[row.size], wrong_percent(row), percent(row, row.error.acne), row.error.edge_displacement,
                    row.error.rmse, row.ms);
    }
}

/// Green: a hundredth of a percent is wrong, red: ten percent.
glm::vec3 color_of(double percent) {
    const double share = std::clamp(std::log10(std::max(percent, 1e-9) / 0.01) / 3.0, 0.0, 1.0);
    return glm::mix(kGreen, kRed, static_cast<float>(share));
}

/// Wrong pixels in percent; a line a filter and bias, a column a size.
Panel table_panel(const Options& options, const std::vector<ShadowRow>& rows) {
    Panel table = empty_panel({options.width, options.height});
    const float width = static_cast<float>(options.width), line_height = static_cast<float>(options.height) / 13.5f;
    const float type = caption_size(options.height);
    const auto write = [&](std::size_t column, std::size_t line, const std::string& text, const glm::vec3& color) {
        const float right = (0.30f + 0.17f * static_cast<float>(column)) * width;
        const float x = column == 0 ? 0.02f * width : right - tools::type_width(text, type);
        table.labels.push_back({{x, (static_cast<float>(line) + 0.85f) * line_height}, text, color, type});
    };
    write(0, 0, "filter, bias", kChalk);
    for (std::size_t s = 0; s < kMapSizes.size(); ++s) write(s + 1, 0, std::to_string(kMapSizes[s]), kChalk);
    for (const ShadowRow& row : rows) {
        const std::size_t line = 1 + kBiases.size() * row.filter + row.bias;
        if (row.size == 0) write(0, line, std::string(kFilters[row.filter]) + ", " + kBiases[row.bias], kDust);
        char text[16];
        std::snprintf(text, sizeof text, "%.3f %%", wrong_percent(row));
        write(row.size + 1, line, text, color_of(wrong_percent(row)));
    }
    return table;
}

/// Wrong pixels over the size of the map, unfiltered; and what is in inverse proportion to it.
Plot size_plot(const std::vector<ShadowRow>& rows) {
    Plot plot = empty_plot("texels a side", "wrong pixels [%]", true, true);
    plot.x_range = {100.0, 10000.0};
    plot.y_range = {0.001, 100.0};
    for (const char* bias : kBiases) plot.series.push_back({bias, {}});
    for (const ShadowRow& row : rows) {
        const double y = std::max(wrong_percent(row), plot.y_range->from);
        if (row.filter == 0) plot.series[row.bias].points.push_back({kMapSizes[row.size], y});
    }
    plot.series.push_back(curve(
        "16 / size", *plot.x_range, [](double size) { return 16.0 / size; }, true));
    return plot;
}

void draw(const Options& options) {
    const std::vector<ShadowRow> rows = measure_shadow_maps(sunny_table(measured_size(options)), kLightSize, kBand);
    print_rows(rows);
    save_panel(options, "table", table_panel(options, rows));
    save_plot(options, "size", "", size_plot(rows));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "93_shadow_resolution", draw);
}
