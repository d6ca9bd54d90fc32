// 91_fresnel_speed: what each Fresnel method costs in time and in error, on pictures seen from 180 directions.
// Page docs/91_fresnel_speed.md | After 40_fresnel, 43_metals | New: evaluate_fresnel(), mean error over pictures
// Break at: evaluate_fresnel | Look at: setup.fresnel, channels.F | Try: kGain 16, "water" in draw(), kRounds 30
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>

#include <glm/common.hpp>

#include "examples/fresnel_views.hpp"
#include "examples/plots.hpp"
#include "lighting/batch/microfacet_passes.hpp"
#include "tools/measure/fresnel_methods.hpp"

using namespace kreda;
using namespace kreda::examples;
using namespace kreda::tools;
using lighting::FresnelMethod;

namespace {

constexpr float kGain = 4.0f;
constexpr int kRounds = 9;     // every method is timed once a round; the median counts
constexpr int kBatches = 400;  // of 512 points, three channels each
constexpr int kAngles = 20'000;

struct TimedMethod {
    std::string name;
    FresnelMethod method;
    glm::vec3 k;
    int table_size = 256;
    double nanoseconds = 0.0;  ///< for the three channels of a point
    double error = 0.0;        ///< mean over the angles on platinum, percent; < 0: it knows neither n nor k
};

/// Milliseconds that evaluate_fresnel takes for kBatches batches.
double time_once(const lighting::CookTorranceSetup& setup, lighting::MicrofacetChannels& channels) {
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < kBatches; ++i) evaluate_fresnel(raster::kBatchCapacity, setup, channels);
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

/// Every method in turn, round after round, so that a busy machine is busy for all.
void time_methods(std::vector<TimedMethod>& methods) {
    const auto channels = std::make_unique<lighting::MicrofacetChannels>();
    for (int i = 0; i < raster::kChannelSize; ++i) {
        channels->v_dot_h.set(i, static_cast<float>(i % raster::kBatchCapacity) / raster::kBatchCapacity);
    }
    lighting::MicrofacetSurface surface;
    surface.f0 = glm::vec3(0.6f);
    channels->surface.set_all(surface);
    std::vector<lighting::CookTorranceSetup> setups;
    for (const TimedMethod& m : methods) {
        lighting::CookTorranceMaterial material;
        material.fresnel = m.method;
        material.table_size = m.table_size;
        material.ior = lighting::published_index("platinum").n;
        material.extinction = m.k;
        setups.push_back(prepare(material));
    }
    std::vector<std::vector<double>> times(methods.size());
    for (int round = 0; round < kRounds; ++round) {
        for (std::size_t m = 0; m < methods.size(); ++m) times[m].push_back(time_once(setups[m], *channels));
    }
    for (std::size_t m = 0; m < methods.size(); ++m) {
        std::nth_element(times[m].begin(), times[m].begin() + kRounds / 2, times[m].end());
        methods[m].nanoseconds = times[m][kRounds / 2] * 1e6 / (kBatches * raster::kBatchCapacity);
    }
}

std::vector<TimedMethod> timed_methods() {
    const lighting::ThreeChannelIndex platinum = lighting::published_index("platinum");
    const std::vector<double> errors =
        mean_errors_percent(fresnel_curves(platinum), platinum, cosines_of_even_angles(kAngles));
    const glm::vec3 k = platinum.k;
    std::vector<TimedMethod> methods = {{"exact, dielectric", FresnelMethod::exact, glm::vec3(0.0f), 2, 0.0, -1.0},
                                        {"exact, metal", FresnelMethod::exact, k, 2, 0.0, 0.0},
                                        {"Schlick", FresnelMethod::schlick, k, 2, 0.0, errors[1]},
                                        {"corrected", FresnelMethod::corrected_schlick, k, 2, 0.0, errors[2]},
                                        {"F82", FresnelMethod::f82, k, 2, 0.0, errors[4]},
                                        {"table of 16", FresnelMethod::table, k, 16, 0.0, errors[5]},
                                        {"table of 256", FresnelMethod::table, k, 256, 0.0, errors[6]},
                                        {"NVIDIA", FresnelMethod::nvidia, k, 2, 0.0, -1.0}};
    time_methods(methods);
    return methods;
}

void print_speed(const std::vector<TimedMethod>& methods) {
    std::printf("Time for one point in a batch loop, relative to the exact dielectric; error on platinum in percent\n");
    for (const TimedMethod& m : methods) {
        std::printf("%-18s %6.2f ns %6.0f %%", m.name.c_str(), m.nanoseconds,
                    100.0 * m.nanoseconds / methods[0].nanoseconds);
        if (m.error >= 0.0) std::printf(" %12.4g", m.error);
        std::printf("\n");
    }
}

/// Error over time. The exact one, whose error is 0, stands on the lower edge. A picture of this machine.
Plot speed_plot(const std::vector<TimedMethod>& methods) {
    Plot plot = empty_plot("time of a point [ns]", "error [%]", true, true);
    plot.x_range = {0.1, 100.0};
    plot.y_range = {0.0001, 10.0};
    Series series{"", {}};
    series.joined = false;
    for (const TimedMethod& m : methods) {
        if (m.error < 0.0) continue;
        series.points.push_back({m.nanoseconds, std::max(m.error, plot.y_range->from)});
        series.point_names.push_back(m.name);
    }
    plot.series = {series};
    return plot;
}

void draw(const Options& options) {
    const std::vector<TimedMethod> methods = timed_methods();
    print_speed(methods);
    save_plot(options, "measured_speed", "platinum", speed_plot(methods));

    const glm::ivec2 size = panel_size(options.width, options.height, 4, 2);
    std::vector<Panel> panels;
    for (const Subject& subject : comparison_subjects()) {
        add_comparison(subject, size, lighting::published_index("platinum"), kGain, panels);
    }
    save_panels(options, "comparison", 4, panels);
    print_picture_errors();
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "91_fresnel_speed", draw);
}
