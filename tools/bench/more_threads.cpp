#include "tools/bench/more_threads.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <numeric>
#include <queue>

#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"
#include "scene/render/threads.hpp"
#include "tools/bench/bench.hpp"

namespace kreda::tools {

namespace {

constexpr int kSimulatedThreads[] = {2, 4, 8, 16, 32, 64};

/// The median of each tile over some frames of one thread, and of what comes before the tiles.
FrameWork work_of(const scene::Scene& scene, int frames) {
    const scene::RenderPlan plan = make_plan(scene);
    scene::RenderBuffers buffers;
    render(scene, plan, buffers, 1);
    const raster::TileGrid& grid = buffers.triangles.grid;
    const auto tiles = static_cast<std::size_t>(grid.columns) * grid.rows;
    std::vector<double> before;
    std::vector<std::vector<double>> of_tile(tiles);
    for (int f = 0; f < frames; ++f) {
        buffers.tile_ms.assign(tiles, 0.0);
        const double total = render(scene, plan, buffers, 1).times.total_ms;
        before.push_back(total - std::accumulate(buffers.tile_ms.begin(), buffers.tile_ms.end(), 0.0));
        for (std::size_t t = 0; t < tiles; ++t) of_tile[t].push_back(buffers.tile_ms[t]);
    }
    FrameWork work{spread_of(before).median, {}};
    for (const std::vector<double>& times : of_tile) work.tile_ms.push_back(spread_of(times).median);
    return work;
}

void print_row(const std::string& path, int frames, int cores) {
    const scene::Scene scene = scene::read_scene(path);
    const FrameWork work = work_of(scene, frames);
    std::printf("| %s | %.2f |", std::filesystem::path(path).stem().string().c_str(), time_frames(scene, frames, 1));
    if (cores > 1) std::printf(" %.2f |", time_frames(scene, frames, cores));
    for (const int threads : kSimulatedThreads) std::printf(" %.2f |", simulated_ms(work, threads));
    std::printf(" %.2f |\n", *std::max_element(work.tile_ms.begin(), work.tile_ms.end()));
    std::fflush(stdout);
}

}  // namespace

double makespan(const std::vector<double>& pieces, int threads) {
    std::priority_queue<double, std::vector<double>, std::greater<>> free_at;  // the earliest on top
    for (int t = 0; t < threads; ++t) free_at.push(0.0);
    double last = 0.0;
    for (const double piece : pieces) {
        const double done = free_at.top() + piece;
        free_at.pop();
        free_at.push(done);
        last = std::max(last, done);
    }
    return last;
}

double simulated_ms(const FrameWork& work, int threads) {
    return work.before_tiles_ms / threads + makespan(work.tile_ms, threads);
}

void measure_threads(const std::vector<std::string>& scenes, int frames) {
    const int cores = scene::thread_count();
    std::string head = "| scene | 1 thread |", line = "| --- | --- |";
    if (cores > 1) head += " " + std::to_string(cores) + " threads |", line += " --- |";
    for (const int threads : kSimulatedThreads)
        head += " " + std::to_string(threads) + ", simulated |", line += " --- |";
    std::printf("milliseconds, medians of %d frames\n\n%s longest tile |\n%s --- |\n", frames, head.c_str(),
                line.c_str());
    for (const std::string& path : scenes) print_row(path, frames, cores);
}

}  // namespace kreda::tools
