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
#include "scene/render/render.hpp"
#include "shadows/compare.hpp"

using namespace kreda;
using namespace kreda::examples;
using shadows::ShadowBias;
using shadows::ShadowFilter;

namespace {

constexpr std::array kSizes = {256, 512, 1024, 2048};
constexpr float kLightSize = 0.02f;  // for pcss
constexpr int kBand = 2;             // samples: errors farther than this from every edge are acne or leaks

const std::array<std::pair<const char*, ShadowFilter>, 3> kFilters = {
    {{"none", ShadowFilter::none}, {"pcf", ShadowFilter::pcf}, {"pcss", ShadowFilter::pcss}}};
const std::array<std::pair<const char*, ShadowBias>, 4> kBiases = {{{"none", ShadowBias::none},
                                                                    {"constant", ShadowBias::constant},
                                                                    {"slope", ShadowBias::slope},
                                                                    {"normal", ShadowBias::normal_offset}}};
const glm::vec3 kBiasColors[4] = {kRed, kYellow, kGreen, kBlue};

/// One setting, and what it costs.
struct Row {
    std::size_t filter = 0, bias = 0, size = 0;  ///< in kFilters, kBiases, kSizes
    shadows::ShadowError error;
    double ms = 0.0;  ///< the map and the whole picture, on one thread
};

double percent(const Row& row, std::uint64_t count) {
    return 100.0 * static_cast<double>(count) / static_cast<double>(row.error.visible);
}

double wrong_percent(const Row& row) {
    return percent(row, row.error.misclassified());
}

/// All settings, sizes first, then biases, then filters.
std::vector<Row> measure(const Options& options) {
    scene::Scene scene = sunny_table({options.width, options.height});
    const std::vector<const scene::View*> views = {scene::find_view("shadow")};
    scene.shadow.method = shadows::ShadowMethod::irregular;  // exact, and it keeps what the camera sees
    scene::RenderBuffers exact, buffers;
    render(scene, make_plan(scene, views), exact);
    scene.shadow.method = shadows::ShadowMethod::map;
    scene.shadow.light_size = kLightSize;
    scene.shadow.size = kSizes.back();
    render(scene, make_plan(scene, views), buffers);  // the first frame allocates: not timed
    std::vector<Row> rows;
    for (std::size_t i = 0; i < kFilters.size() * kBiases.size() * kSizes.size(); ++i) {
        Row row{i / 16, i / 4 % 4, i % 4, {}, 0.0};
        scene.shadow.filter = kFilters[row.filter].second;
        scene.shadow.bias = kBiases[row.bias].second;
        scene.shadow.size = kSizes[row.size];
        row.ms = render(scene, make_plan(scene, views), buffers, 1).times.total_ms;
        row.error = compare_shadows(exact.visible.samples(), exact.views[0].values, buffers.views[0].values, kBand);
        rows.push_back(row);
    }
    return rows;
}

void print_rows(const std::vector<Row>& rows) {
    std::printf("filter bias      size   wrong %%    acne %%  edge off/px     rmse       ms\n");
    for (const Row& row : rows) {
        std::printf("%-6s %-8s %5d %9.3f %9.3f %12.3f %8.4f %8.1f\n", kFilters[row.filter].first,
                    kBiases[row.bias].first, kSizes[row.size], wrong_percent(row), percent(row, row.error.acne),
                    row.error.edge_displacement, row.error.rmse, row.ms);
    }
}

/// Green: a hundredth of a percent is wrong, red: ten percent.
glm::vec3 color_of(double percent) {
    const double share = std::clamp(std::log10(std::max(percent, 1e-9) / 0.01) / 3.0, 0.0, 1.0);
    return glm::mix(kGreen, kRed, static_cast<float>(share));
}

/// Wrong pixels in percent; a line a filter and bias, a column a size.
Image table_picture(const Options& options, const std::vector<Row>& rows) {
    Image image = make_board(options.width, options.height);
    const int scale = text_scale(options.height);
    const auto write = [&](std::size_t column, std::size_t line, const std::string& text, const glm::vec3& color) {
        const int x = column == 0 ? 2 * scale : options.width * (10 + 18 * static_cast<int>(column)) / 100;
        draw_text(image, x, options.height / 13 * static_cast<int>(line) + 3 * scale, text, color, scale);
    };
    write(0, 0, "filter, bias", kChalk);
    for (std::size_t s = 0; s < kSizes.size(); ++s) write(s + 1, 0, std::to_string(kSizes[s]), kChalk);
    for (const Row& row : rows) {
        const std::size_t line = 1 + kBiases.size() * row.filter + row.bias;
        write(0, line, std::string(kFilters[row.filter].first) + " " + kBiases[row.bias].first, kDust);
        char text[16];
        std::snprintf(text, sizeof text, "%.3f %%", wrong_percent(row));
        write(row.size + 1, line, text, color_of(wrong_percent(row)));
    }
    return image;
}

/// Wrong pixels over the size of the map, unfiltered; dashed: in inverse proportion.
Image size_chart(const Options& options, const std::vector<Row>& rows) {
    Chart chart = make_chart({options.width, options.height}, options.height, "wrong pixels [%] over texels a side",
                             {100.0, 10000.0, 0.0, true}, {0.001, 100.0, 0.0, true});
    plot(
        chart, kDust, [](double size) { return 16.0 / size; }, true);
    for (const Row& row : rows) {
        const double y = std::max(wrong_percent(row), chart.y.from);
        if (row.filter == 0) plot_point(chart, kSizes[row.size], y, "", kBiasColors[row.bias]);
    }
    for (std::size_t b = 0; b < kBiases.size(); ++b) legend(chart, kBiases[b].first, kBiasColors[b], {0.8f, 0.06f});
    return chart.image;
}

void draw(const Options& options) {
    const std::vector<Row> rows = measure(options);
    print_rows(rows);
    save(options, "table", table_picture(options, rows));
    save(options, "size", size_chart(options, rows));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "93_shadow_resolution", draw);
}
