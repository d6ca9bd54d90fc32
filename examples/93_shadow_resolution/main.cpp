// 93_shadow_resolution: size of the map x bias x filter: the error of each against the exact shadow, and its time.
// Page docs/93_shadow_resolution.md | After 67_methods_compared | New: a table of settings, error over size
// Break at: compare_shadows | Look at: error | Try: kBand 0, kLightSize 0.1, table_scene() with its lamp
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <glm/common.hpp>

#include "examples/chart.hpp"
#include "examples/example.hpp"
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
const glm::vec3 kBiasColors[4] = {kRed, kYellow, kGreen, kBlue};

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
Image table_picture(const Options& options, const std::vector<ShadowRow>& rows) {
    Image image = make_board(options.width, options.height);
    const int scale = text_scale(options.height);
    const auto write = [&](std::size_t column, std::size_t line, const std::string& text, const glm::vec3& color) {
        const int x = column == 0 ? 2 * scale : options.width * (10 + 18 * static_cast<int>(column)) / 100;
        draw_text(image, x, options.height / 13 * static_cast<int>(line) + 3 * scale, text, color, scale);
    };
    write(0, 0, "filter, bias", kChalk);
    for (std::size_t s = 0; s < kMapSizes.size(); ++s) write(s + 1, 0, std::to_string(kMapSizes[s]), kChalk);
    for (const ShadowRow& row : rows) {
        const std::size_t line = 1 + kBiases.size() * row.filter + row.bias;
        write(0, line, std::string(kFilters[row.filter]) + " " + kBiases[row.bias], kDust);
        char text[16];
        std::snprintf(text, sizeof text, "%.3f %%", wrong_percent(row));
        write(row.size + 1, line, text, color_of(wrong_percent(row)));
    }
    return image;
}

/// Wrong pixels over the size of the map, unfiltered; dashed: in inverse proportion.
Image size_chart(const Options& options, const std::vector<ShadowRow>& rows) {
    Chart chart = make_chart({options.width, options.height}, options.height, "wrong pixels [%] over texels a side",
                             {100.0, 10000.0, 0.0, true}, {0.001, 100.0, 0.0, true});
    plot(
        chart, kDust, [](double size) { return 16.0 / size; }, true);
    for (const ShadowRow& row : rows) {
        const double y = std::max(wrong_percent(row), chart.y.from);
        if (row.filter == 0) plot_point(chart, kMapSizes[row.size], y, "", kBiasColors[row.bias]);
    }
    for (std::size_t b = 0; b < kBiases.size(); ++b) legend(chart, kBiases[b], kBiasColors[b], {0.8f, 0.06f});
    return chart.image;
}

void draw(const Options& options) {
    const std::vector<ShadowRow> rows =
        measure_shadow_maps(sunny_table({options.width, options.height}), kLightSize, kBand);
    print_rows(rows);
    save(options, "table", table_picture(options, rows));
    save(options, "size", size_chart(options, rows));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "93_shadow_resolution", draw);
}
