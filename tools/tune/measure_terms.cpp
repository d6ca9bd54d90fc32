// Step 2 of tune.hpp: every option alone.
#include <algorithm>
#include <cmath>

#include "scene/plan/plan_cost.hpp"
#include "tools/tune/tune.hpp"

namespace kreda::tools {

namespace {

/// The size of a picture of so many pixels, as wide for its height as the scene's.
Setting probe_size(const scene::ImageSettings& image, int pixels) {
    const double all = static_cast<double>(image.width) * image.height;
    const double scale = std::min(1.0, std::sqrt(pixels / all));
    const auto side = [&](int n) { return std::to_string(std::max(1, static_cast<int>(std::lround(scale * n)))); };
    return {"image", -1, "size", "[" + side(image.width) + "," + side(image.height) + "]"};
}

/// A scene that shares its environment's image with the first: what is baked of it need not be baked again.
void share_environment(const scene::Scene& first, scene::Scene& scene) {
    if (scene.environment.file == first.environment.file) scene.environment.image = first.environment.image;
}

/// One scene on its way to be measured.
struct Probe {
    scene::Scene scene;
    scene::RenderBuffers buffers;
    raster::Image picture;
    std::vector<double> frames;
    MeasuredOption result;
};

/// Its picture, what was baked for it, and its time where the plan says the cost.
void draw_first(Probe& probe, const TuneOptions& options) {
    const Picture drawn = draw_picture(probe.scene, probe.buffers, options.threads);
    probe.picture = drawn.encoded;
    if (options.cost_by == CostBy::plan) {
        const scene::RenderPlan plan = make_plan(probe.scene);
        probe.result.bake = 1e-6 * baking_operations(plan);
        probe.result.frame = 1e-6 * total_operations(plan) - probe.result.bake;
    } else {
        probe.result.bake = drawn.bake_ms;
    }
}

/// The options in turn, round after round; the median counts.
void time_frames(std::vector<Probe>& probes, const TuneOptions& options) {
    if (options.cost_by == CostBy::plan) return;
    for (int round = 0; round < options.rounds; ++round) {
        for (Probe& probe : probes) {
            probe.frames.push_back(draw_picture(probe.scene, probe.buffers, options.threads).frame_ms);
        }
    }
    for (Probe& probe : probes) {
        const auto middle = probe.frames.begin() + static_cast<std::ptrdiff_t>(probe.frames.size() / 2);
        std::nth_element(probe.frames.begin(), middle, probe.frames.end());
        probe.result.frame = *middle;
    }
}

}  // namespace

double budget_of(const CodeError& error) {
    return std::max(error.mean, error.p99 / 4.0);
}

MeasuredTerms measure_terms(const SceneSource& source, const std::vector<Term>& terms, const TuneOptions& options) {
    const Setting size = probe_size(read_with(source, {}).image, options.probe_pixels);
    Probe own;
    own.scene = read_with(source, {size});
    draw_first(own, options);
    MeasuredTerms measured;
    measured.renders = 1;
    std::size_t all = 0;
    for (const Term& term : terms) all += term.options.size();
    for (const Term& term : terms) {
        std::vector<Probe> probes(term.options.size());
        for (std::size_t o = 0; o < probes.size(); ++o) {
            std::vector<Setting> settings = term.options[o].settings;
            settings.push_back(size);
            probes[o].scene = read_with(source, settings);
            share_environment(own.scene, probes[o].scene);
            const bool bakes_anew = settings.front().table == "environment";
            if (!bakes_anew) probes[o].buffers.environment = own.buffers.environment;
            draw_first(probes[o], options);
            measured.renders += static_cast<int>(o) != term.own;
            if (options.progress) options.progress(static_cast<double>(measured.renders) / static_cast<double>(all));
        }
        time_frames(probes, options);
        const raster::Image& exact = probes[static_cast<std::size_t>(term.oracle)].picture;
        measured.options.emplace_back();
        for (Probe& probe : probes) {
            probe.result.error = code_error(probe.picture, exact);
            measured.options.back().push_back(probe.result);
        }
    }
    std::vector<Probe> alone;
    alone.push_back(std::move(own));
    time_frames(alone, options);
    measured.own = alone.front().result;
    return measured;
}

}  // namespace kreda::tools
