// time_passes FRAMES SCENE.toml...: for each scene at 640 x 360 on one thread a line a pass, the median of FRAMES after
// two seconds. The same program natively and for node shows which passes WebAssembly draws slower: docs/performance.md.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"

using namespace kreda;

namespace {

constexpr std::chrono::seconds kWarm{2};  // until an engine has compiled every loop with its second, better compiler

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

void time_scene(const char* path, int frames) {
    scene::Scene scene = scene::read_scene(path);
    scene.image.width = 640;
    scene.image.height = 360;
    const scene::RenderPlan plan = make_plan_for(scene, {.prune = false});
    scene::RenderBuffers buffers;
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - begin < kWarm) render(scene, plan, buffers, 1);
    std::vector<scene::StageTimes> times;
    for (int i = 0; i < frames; ++i) times.push_back(render(scene, plan, buffers, 1).times);
    std::vector<double> ms(times.size());
    std::transform(times.begin(), times.end(), ms.begin(), [](const auto& one) { return one.total_ms; });
    std::printf("%8.3f ms %s\n", median(ms), path);
    for (std::size_t s = 0; s < times[0].stages.size(); ++s) {
        std::transform(times.begin(), times.end(), ms.begin(), [s](const auto& one) { return one.stages[s].second; });
        std::printf("%8.3f    %s\n", median(ms), times[0].stages[s].first.c_str());
    }
}

}  // namespace

int main(int argc, char** argv) {
    const int frames = argc > 1 ? std::max(1, std::atoi(argv[1])) : 1;
    for (int i = 2; i < argc; ++i) {
        try {
            time_scene(argv[i], frames);
        } catch (const std::exception& error) { std::printf("%s\n", error.what()); }
    }
}
