// 92_shading_frequency: flat, Gouraud and Phong shading against the number of triangles: what each misses.
// Page docs/92_shading_frequency.md | After 24_shading, 90_what_a_scene_requires | New: code_error, FrequencyRow
// Break at: walk_frame | Look at: frame.plan.frequency | Try: shininess 4 or 200, detail 256
#include <cstdio>
#include <string>
#include <vector>

#include "examples/lit_scene.hpp"
#include "examples/plots.hpp"
#include "tools/measure/frequency_error.hpp"

using namespace kreda;
using namespace kreda::examples;
using namespace kreda::tools;

namespace {

const std::vector<int> kDetails = {8, 16, 32, 64, 128, 256};
constexpr std::size_t kShown = 4;  // details that have pictures: the coarsest
constexpr int kFramesTimed = 5;

/// A row of pictures for each frequency, a column for each detail.
std::vector<Panel> ball_panels(const Options& options, const std::vector<std::vector<FrequencyRow>>& rows) {
    const glm::ivec2 size = panel_size(options.width, options.height, kShown, static_cast<int>(rows.size()));
    std::vector<Panel> panels;
    for (const std::vector<FrequencyRow>& of_frequency : rows) {
        for (std::size_t d = 0; d < kShown; ++d) {
            const FrequencyRow& row = of_frequency[d];
            char caption[64];
            std::snprintf(caption, sizeof caption, "%s, %zu: %.2f codes", kFrequencyNames[row.frequency], row.triangles,
                          row.error.mean);
            panels.push_back(captioned(shiny_ball(row.frequency, row.detail, size), caption));
        }
    }
    return panels;
}

Plot error_plot(const std::vector<std::vector<FrequencyRow>>& rows) {
    Plot plot = empty_plot("triangles", "mean error [codes]", true, true);
    for (const std::vector<FrequencyRow>& of_frequency : rows) {
        plot.series.push_back({kFrequencyNames[of_frequency[0].frequency], {}});
        for (const FrequencyRow& row : of_frequency)
            plot.series.back().points.emplace_back(static_cast<double>(row.triangles), row.error.mean);
    }
    return plot;
}

void print_row(const FrequencyRow& row) {
    std::printf("%-8s %6d %10zu %10.3f %8.1f %8.2f\n", kFrequencyNames[row.frequency], row.detail, row.triangles,
                row.error.mean, row.error.p99, row.ms);
}

void draw(const Options& options) {
    const Image exact = finest_ball();
    std::vector<std::vector<FrequencyRow>> rows;
    std::printf("light    detail  triangles mean codes  99 %%      ms\n");
    for (std::size_t f = 0; f < kFrequencyNames.size(); ++f) {
        rows.push_back(measure_frequency_rows(f, kDetails, exact, kFramesTimed, 1));
        for (const FrequencyRow& row : rows.back()) print_row(row);
    }
    save_panels(options, "balls", static_cast<int>(kShown), ball_panels(options, rows));
    save_plot(options, "error", "", error_plot(rows));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "92_shading_frequency", draw);
}
