// Step 2 of tune.hpp: every option alone.
#include <algorithm>
#include <cmath>

#include "scene/plan/plan_cost.hpp"
#include "tools/tune/tune.hpp"

namespace kreda::tools {

namespace {

/// A scene that shares its environment's image with the first: what is baked of it need not be baked again.
void share_environment(const scene::Scene& first, scene::Scene& scene) {
    if (scene.environment.file == first.environment.file) scene.environment.image = first.environment.image;
}

constexpr double kLong = 400.0;  // ms: what takes longer is timed once

constexpr double kNoise = 0.04;  // of a frame: what differs by less takes the same time

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
        probe.result.frame = 1e-6 * total_operations(plan);
    } else {
        probe.result.bake = drawn.bake_ms;
        probe.frames = {drawn.frame_ms};
    }
}

/// The options in turn, round after round; the median counts.
void time_frames(std::vector<Probe>& probes, const TuneOptions& options) {
    if (options.cost_by == CostBy::plan) return;
    for (int round = 1; round < options.rounds; ++round) {
        for (Probe& probe : probes) {
            if (probe.frames.front() > kLong) continue;
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

Setting probe_size(const scene::ImageSettings& image, int pixels) {
    const double all = static_cast<double>(image.width) * image.height;
    const double scale = std::min(1.0, std::sqrt(pixels / all));
    const auto side = [&](int n) { return std::to_string(std::max(1, static_cast<int>(std::lround(scale * n)))); };
    return {"image", -1, "size", "[" + side(image.width) + "," + side(image.height) + "]"};
}

double budget_of(const CodeError& error) {
    return std::max(error.mean, error.p99 / 4.0);
}

void limit_oracle(const SceneSource& source, std::vector<Term>& terms, const TuneOptions& options) {
    const auto is_samples = [](const Term& term) {
        return term.options.front().settings.front().key == "samples" && term.cost == CostKind::multiplied;
    };
    const auto samples = std::find_if(terms.begin(), terms.end(), is_samples);
    if (samples == terms.end()) return;
    std::vector<Setting> settings = {probe_size(read_with(source, {}).image, options.probe_pixels / 4)};
    for (const Term& term : terms) {
        const int chosen = is_samples(term) ? term.base : term.oracle;
        const std::vector<Setting>& more = term.options[static_cast<std::size_t>(chosen)].settings;
        settings.insert(settings.end(), more.begin(), more.end());
    }
    const scene::Scene scene = read_with(source, settings), whole = read_with(source, {});
    scene::RenderBuffers buffers;
    double ms = draw_picture(scene, buffers, options.threads).frame_ms;  // the first frame asks for memory, too
    for (int again = 0; again < 2 && ms < kLong; ++again) {
        ms = std::min(ms, draw_picture(scene, buffers, options.threads).frame_ms);
    }
    const auto pixels = [](const scene::ImageSettings& image) {
        return static_cast<double>(image.width) * image.height;
    };
    const double seconds = 1e-3 * ms * pixels(whole.image) / pixels(scene.image);  // with one sample a pixel
    const auto n_of = [&](int o) { return std::stoi(samples->options[static_cast<std::size_t>(o)].name); };
    const int own = n_of(samples->own);
    std::vector<TermOption> kept;
    int most = 0;
    for (int o = 0; o < static_cast<int>(samples->options.size()); ++o) {
        const int n = n_of(o);
        if (n > own && n > 2 && seconds * n * n > options.oracle_seconds) continue;
        kept.push_back(samples->options[static_cast<std::size_t>(o)]);
        most = std::max(most, n);
    }
    samples->options = kept;
    for (int o = 0; o < static_cast<int>(kept.size()); ++o) {
        if (n_of(o) == own) samples->own = o;
        if (n_of(o) == most) samples->oracle = o;
    }
}

MeasuredTerms measure_terms(const SceneSource& source, const std::vector<Term>& terms, const TuneOptions& options) {
    std::vector<Setting> bases = {probe_size(read_with(source, {}).image, options.probe_pixels)};
    std::size_t all = 0;
    for (const Term& term : terms) {
        const std::vector<Setting>& more = term.options[static_cast<std::size_t>(term.base)].settings;
        if (term.base != term.own) bases.insert(bases.end(), more.begin(), more.end());
        all += term.options.size();
    }
    std::vector<Probe> base(1);
    base[0].scene = read_with(source, bases);
    draw_first(base[0], options);
    time_frames(base, options);
    MeasuredTerms measured;
    measured.base = base[0].result;
    measured.renders = 1;
    for (const Term& term : terms) {
        std::vector<Probe> probes(term.options.size());
        for (std::size_t o = 0; o < probes.size(); ++o) {
            std::vector<Setting> settings = bases;
            const std::vector<Setting>& more = term.options[o].settings;
            settings.insert(settings.end(), more.begin(), more.end());
            probes[o].scene = read_with(source, settings);
            share_environment(base[0].scene, probes[o].scene);
            const bool bakes_anew = more.front().table == "environment";
            if (!bakes_anew) probes[o].buffers.environment = base[0].buffers.environment;
            draw_first(probes[o], options);
            measured.renders += static_cast<int>(o) != term.base;
            if (options.progress) options.progress(static_cast<double>(measured.renders) / static_cast<double>(all));
        }
        time_frames(probes, options);
        const double noise = options.cost_by == CostBy::plan ? 0.0 : kNoise * measured.base.frame;
        const double base_frame = probes[static_cast<std::size_t>(term.base)].result.frame;
        for (Probe& probe : probes) {
            if (std::abs(probe.result.frame - base_frame) < noise) probe.result.frame = base_frame;
        }
        const raster::Image& exact = probes[static_cast<std::size_t>(term.oracle)].picture;
        measured.options.emplace_back();
        for (Probe& probe : probes) {
            probe.result.error = code_error(probe.picture, exact);
            measured.options.back().push_back(probe.result);
        }
    }
    return measured;
}

}  // namespace kreda::tools
