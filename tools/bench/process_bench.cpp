#include "tools/bench/process_bench.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "scene/error.hpp"
#include "scene/render/stopwatch.hpp"
#include "tools/bench/time_report.hpp"
#include "tools/progress_bar.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A folder for pictures and reports that nobody keeps.
struct ScratchFolder {
    fs::path path = fs::temp_directory_path() / ("kreda_bench_" + std::to_string(getpid()));

    ScratchFolder() {
        fs::create_directories(path);
    }
    ~ScratchFolder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
};

/// What one process took.
struct ProcessCost {
    double wall_ms = 0.0;
    double processor_ms = 0.0;  ///< of all threads, user and system
    double megabytes = 0.0;     ///< the most it held in memory
    json times;                 ///< what --time printed
};

double milliseconds(const timeval& time) {
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
}

/// In the child: this same program draws the scene; its report goes into a file.
[[noreturn]] void become_render(const std::string& scene, int threads, const fs::path& folder) {
    const std::string picture = (folder / "picture.png").string(), count = std::to_string(threads);
    const int report = open((folder / "report.json").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(report, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    execl("/proc/self/exe", "kreda", "render", scene.c_str(), "-o", picture.c_str(), "--time", "--threads",
          count.c_str(), static_cast<char*>(nullptr));
    _exit(127);
}

ProcessCost run_render(const std::string& scene, int threads, const fs::path& folder) {
    scene::Stopwatch watch;
    const pid_t child = fork();
    if (child < 0) throw scene::UserError("kreda bench: cannot start a process");
    if (child == 0) become_render(scene, threads, folder);
    int status = 0;
    rusage used{};
    wait4(child, &status, 0, &used);
    ProcessCost cost;
    cost.wall_ms = watch.lap_ms();
    cost.processor_ms = milliseconds(used.ru_utime) + milliseconds(used.ru_stime);
    cost.megabytes = static_cast<double>(used.ru_maxrss) / 1024.0;
    cost.times = json::parse(bytes_of_file((folder / "report.json").string()), nullptr, false);
    const bool drawn = WIFEXITED(status) && WEXITSTATUS(status) == 0 && !cost.times.is_discarded();
    if (!drawn) { throw scene::UserError(scene::Place{scene}, "cannot be drawn; kreda render " + scene + " says why"); }
    return cost;
}

template <class Number>
double median_of(const std::vector<ProcessCost>& costs, Number number) {
    std::vector<double> values;
    for (const ProcessCost& cost : costs) values.push_back(number(cost));
    return median(values);
}

double around(const ProcessCost& cost, const char* step) {
    return cost.times.at("around").at(step).get<double>();
}

void print_row(const std::string& scene, const std::vector<ProcessCost>& costs) {
    const auto wall = [](const ProcessCost& cost) { return cost.wall_ms; };
    const auto by_wall = [](const ProcessCost& a, const ProcessCost& b) { return a.wall_ms < b.wall_ms; };
    const auto [least, greatest] = std::minmax_element(costs.begin(), costs.end(), by_wall);
    std::printf("| %s | %.0f (%.0f..%.0f) | %.0f | %.0f | %.0f | %.0f | %.0f | %.0f | %.0f |\n",
                fs::path(scene).filename().c_str(), median_of(costs, wall), least->wall_ms, greatest->wall_ms,
                median_of(costs, [](const ProcessCost& c) { return c.processor_ms; }),
                median_of(costs, [](const ProcessCost& c) { return c.megabytes; }),
                median_of(costs, [](const ProcessCost& c) { return around(c, "loading"); }),
                median_of(costs, [](const ProcessCost& c) { return around(c, "baking"); }),
                median_of(costs, [](const ProcessCost& c) { return c.times.at("total_ms").get<double>(); }),
                median_of(costs, [](const ProcessCost& c) { return around(c, "encoding"); }),
                median_of(costs, [](const ProcessCost& c) { return around(c, "writing"); }));
}

}  // namespace

void time_processes(const ProcessOptions& options) {
    const ScratchFolder folder;
    std::vector<std::vector<ProcessCost>> costs(options.scenes.size());
    for (int round = 0; round < options.rounds; ++round) {
        for (std::size_t s = 0; s < options.scenes.size(); ++s) {
            show_status("round " + std::to_string(round + 1) + " of " + std::to_string(options.rounds) + ": " +
                        options.scenes[s]);
            costs[s].push_back(run_render(options.scenes[s], options.threads, folder.path));
        }
    }
    show_status("");
    std::printf("Whole processes, %d threads, medians of %d; milliseconds.\n\n", options.threads, options.rounds);
    std::printf(
        "| scene | command to PNG (least..greatest) | processor time | MB | load and plan | bake | frame | encode | "
        "write "
        "|\n");
    std::printf("| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (std::size_t s = 0; s < options.scenes.size(); ++s) print_row(options.scenes[s], costs[s]);
}

}  // namespace kreda::tools
