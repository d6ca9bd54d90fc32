// 94_environment_samples: how many samples one percent costs, for every roughness and sky, and what a bake takes.
// Page docs/94_environment_samples.md | After 52_prefilter | New: samples_needed(), what a rule of thumb is worth
// Break at: lobe_average | Look at: n, alpha, sum, total | Try: kWanted 0.3, kRounds 9
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "examples/plots.hpp"
#include "examples/stopwatch.hpp"
#include "lighting/environment/environment_image.hpp"
#include "tools/measure/irradiance_error.hpp"
#include "tools/measure/prefilter_levels.hpp"

using namespace kreda;
using namespace kreda::examples;
using namespace kreda::tools;
using lighting::CubeMap;

namespace {

constexpr double kWanted = 1.0;            // mean error in percent
constexpr int kFewest = 8, kMost = 16384;  // samples
constexpr int kFirstLevel = 4;             // alpha 1/8: narrower lobes see single texels
constexpr int kSize = 8;                   // texels a side of a face where the error is taken: 384 directions
constexpr int kRounds = 2;

/// A sky, and its exact blur for levels 4 to 7.
struct Subject {
    const char* name;
    CubeMap radiance;
    std::vector<CubeMap> exact;
};

Subject make_subject(const char* name, lighting::Sky sky) {
    Subject subject{name, lighting::cube_from_sky(sky, 64), {}};
    for (int level = kFirstLevel; level < lighting::kPrefilterLevels; ++level) {
        subject.exact.push_back(exact_level(subject.radiance, lighting::alpha_of_level(level), kSize));
    }
    return subject;
}

double error_percent(const CubeMap& radiance, const CubeMap& exact, float alpha, int samples) {
    return 100.0 * map_error(sampled_level(radiance, alpha, samples, kSize), exact).mean;
}

/// The first power of 2 whose error is small enough.
int samples_needed(const CubeMap& radiance, const CubeMap& exact, float alpha) {
    int samples = kFewest;
    while (samples < kMost && error_percent(radiance, exact, alpha, samples) > kWanted) samples *= 2;
    return samples;
}

/// Samples that one percent needs over alpha, both on logarithmic axes: a rule "samples in proportion to alpha" is a
/// line.
Plot needed_plot(const std::vector<Subject>& subjects) {
    Plot plot = empty_plot("$α$", "samples for a mean error of 1 %", true, true);
    plot.x_range = {0.1, 1.0};
    plot.y_range = {10.0, 100000.0};
    std::printf("samples for a mean error of %g %%  %10s %8s %8s %8s\n", kWanted, "1/8", "1/4", "1/2", "alpha 1");
    for (const Subject& subject : subjects) {
        for (const bool mips : {false, true}) {
            const CubeMap radiance = mips ? subject.radiance : without_mips(subject.radiance);
            Series needed{std::string(subject.name) + (mips ? ", from mips" : ", plain"), {}};
            std::printf("%-12s %-16s", subject.name, mips ? "from mips" : "plain");
            for (int level = kFirstLevel; level < lighting::kPrefilterLevels; ++level) {
                const float alpha = lighting::alpha_of_level(level);
                const CubeMap& exact = subject.exact[static_cast<std::size_t>(level - kFirstLevel)];
                needed.points.push_back({alpha, samples_needed(radiance, exact, alpha)});
                std::printf(" %8.0f", needed.points.back().y);
            }
            std::printf("\n");
            plot.series.push_back(needed);
        }
    }
    const auto kreda = [](double alpha) { return std::max(32.0, 2048.0 * alpha); };
    plot.series.push_back(curve("Kreda's", *plot.x_range, kreda, true));
    return plot;
}

// ------------------------------------------------------------------------------------------------- time

/// Mean error of levels 4 to 7 when level 7 takes `samples` and the others their share.
double error_of_bake(const Subject& subject, int samples) {
    double sum = 0.0;
    for (int level = kFirstLevel; level < lighting::kPrefilterLevels; ++level) {
        const float alpha = lighting::alpha_of_level(level);
        const int share = std::max(32, static_cast<int>(static_cast<float>(samples) * alpha));
        sum +=
            error_percent(subject.radiance, subject.exact[static_cast<std::size_t>(level - kFirstLevel)], alpha, share);
    }
    return sum / static_cast<double>(subject.exact.size());
}

/// Error over the time of a bake, all levels of a map of 64 x 64 texels a face. A picture of this machine.
Plot time_plot(const std::vector<Subject>& subjects) {
    const CubeMap sky = lighting::cube_from_sky(lighting::Sky::sunset, 64);
    const std::vector<int> counts = {128, 512, 2048};
    std::vector<std::function<void()>> works;
    for (const int samples : counts) works.push_back([&sky, samples] { (void)prefilter(sky, {.samples = samples}); });
    const std::vector<double> times = shortest_times(works, kRounds);
    Plot plot = empty_plot("time of a bake [ms]", "mean error [%]", true, true);
    plot.x_range = {10.0, 10000.0};
    plot.y_range = {0.01, 100.0};
    plot.key = "inside right top";
    for (const Subject& subject : subjects) plot.series.push_back({subject.name, {}});
    std::printf("\n%-10s %8s", "samples", "ms");
    for (const Subject& subject : subjects) std::printf(" %10s", subject.name);
    std::printf("   (error in percent)\n");
    for (std::size_t i = 0; i < counts.size(); ++i) {
        std::printf("%-10d %8.1f", counts[i], times[i]);
        for (std::size_t k = 0; k < subjects.size(); ++k) {
            plot.series[k].points.push_back({times[i], error_of_bake(subjects[k], counts[i])});
            std::printf(" %10.3f", plot.series[k].points.back().y);
        }
        std::printf("\n");
    }
    return plot;
}

void draw(const Options& options) {
    const std::vector<Subject> subjects = {make_subject("gradient", lighting::Sky::gradient),
                                           make_subject("studio", lighting::Sky::studio),
                                           make_subject("sunset", lighting::Sky::sunset)};
    save_plot(options, "needed", "", needed_plot(subjects));
    save_plot(options, "measured_time", "", time_plot(subjects));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "94_environment_samples", draw);
}
