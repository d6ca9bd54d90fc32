// 94_environment_samples: how many samples one percent costs, for every roughness and sky, and what a bake takes.
// Page docs/94_environment_samples.md | After 52_prefilter | New: samples_needed(), what a rule of thumb is worth
// Break at: lobe_average | Look at: n, alpha, sum, total | Try: kWanted 0.3, kRounds 9
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "examples/chart.hpp"
#include "examples/example.hpp"
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
    glm::vec3 color;
    CubeMap radiance;
    std::vector<CubeMap> exact;
};

Subject make_subject(const char* name, glm::vec3 color, lighting::Sky sky) {
    Subject subject{name, color, lighting::cube_from_sky(sky, 64), {}};
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
Image needed_chart(const Options& options, const std::vector<Subject>& subjects) {
    Chart chart = make_chart({options.width, options.height}, options.height, "samples for 1 % over alpha",
                             {0.1, 1.0, 0.0, true}, {10.0, 100000.0, 0.0, true});
    std::printf("samples for a mean error of %g %%  %10s %8s %8s %8s\n", kWanted, "1/8", "1/4", "1/2", "alpha 1");
    for (const Subject& subject : subjects) {
        for (const bool mips : {false, true}) {
            const CubeMap radiance = mips ? subject.radiance : without_mips(subject.radiance);
            std::vector<glm::dvec2> needed;
            std::printf("%-12s %-16s", subject.name, mips ? "from mips" : "plain");
            for (int level = kFirstLevel; level < lighting::kPrefilterLevels; ++level) {
                const float alpha = lighting::alpha_of_level(level);
                const CubeMap& exact = subject.exact[static_cast<std::size_t>(level - kFirstLevel)];
                needed.push_back({alpha, samples_needed(radiance, exact, alpha)});
                std::printf(" %8.0f", needed.back().y);
            }
            std::printf("\n");
            plot_points(chart, subject.color, needed, !mips);
        }
        legend(chart, subject.name, subject.color, {0.03f, 0.03f});
    }
    plot(chart, kDust, [](double alpha) { return std::max(32.0, 2048.0 * alpha); });
    legend(chart, "Kreda's", kDust, {0.03f, 0.03f});
    return chart.image;
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
Image time_chart(const Options& options, const std::vector<Subject>& subjects) {
    const CubeMap sky = lighting::cube_from_sky(lighting::Sky::sunset, 64);
    const std::vector<int> counts = {128, 512, 2048};
    std::vector<std::function<void()>> works;
    for (const int samples : counts) works.push_back([&sky, samples] { (void)prefilter(sky, {.samples = samples}); });
    const std::vector<double> times = shortest_times(works, kRounds);
    Chart chart = make_chart({options.width, options.height}, options.height, "error in percent over ms",
                             {10.0, 10000.0, 0.0, true}, {0.01, 100.0, 0.0, true});
    std::printf("\n%-10s %8s", "samples", "ms");
    for (const Subject& subject : subjects) std::printf(" %10s", subject.name);
    std::printf("   (error in percent)\n");
    std::vector<std::vector<glm::dvec2>> curves(subjects.size());
    for (std::size_t i = 0; i < counts.size(); ++i) {
        std::printf("%-10d %8.1f", counts[i], times[i]);
        for (std::size_t k = 0; k < subjects.size(); ++k) {
            curves[k].push_back({times[i], error_of_bake(subjects[k], counts[i])});
            std::printf(" %10.3f", curves[k].back().y);
        }
        std::printf("\n");
    }
    for (std::size_t k = 0; k < subjects.size(); ++k) {
        plot_points(chart, subjects[k].color, curves[k]);
        legend(chart, subjects[k].name, subjects[k].color, {0.7f, 0.03f});
    }
    return chart.image;
}

void draw(const Options& options) {
    const std::vector<Subject> subjects = {make_subject("gradient", kGreen, lighting::Sky::gradient),
                                           make_subject("studio", kBlue, lighting::Sky::studio),
                                           make_subject("sunset", kOrange, lighting::Sky::sunset)};
    save(options, "needed", needed_chart(options, subjects));
    save(options, "measured_time", time_chart(options, subjects));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "94_environment_samples", draw);
}
