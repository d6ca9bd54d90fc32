// Timing scenes: our own frames, and those of another renderer in turn, so that a machine that is busy is busy for
// both.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace kreda::tools {

struct BenchOptions {
    std::string workloads;               ///< folder with WN.toml and WN.mesa
    std::string mesa;                    ///< the program mesa_peer; empty: only ours
    std::vector<std::string> libraries;  ///< folders of Mesa's libraries, one a version; none: the system's
    int rounds = 5;                      ///< how often the programs take turns
    int frames = 10;                     ///< frames a turn, of which the program reports the median
    int threads = 2;
};

/// Milliseconds of one scene over the rounds: median, least and greatest.
struct Spread {
    double median = 0.0, least = 0.0, greatest = 0.0;
};

[[nodiscard]] Spread spread_of(std::vector<double> values);

/// Median frame of one turn, milliseconds from the loaded scene to the linear film.
[[nodiscard]] double time_frames(const scene::Scene& scene, int frames, int threads);

/// The workloads W1 .. W7, ours beside Mesa's, as a Markdown table on stdout.
void compare_with_mesa(const BenchOptions& options);

/// Time against pixels, triangles, lights and threads, with the slope, as Markdown tables on stdout.
void measure_growth(int frames, int threads);

}  // namespace kreda::tools
