#include "scene/render/walk_passes.hpp"

#include <algorithm>
#include <numeric>

#include "scene/plan/pass_functions.hpp"
#include "scene/render/pass_work.hpp"
#include "scene/render/stopwatch.hpp"
#include "scene/render/tile_pass.hpp"

namespace kreda::scene {

namespace {

bool is_of_batch(const PlannedPass& pass) {
    return pass.scope == PassScope::batch || pass.scope == PassScope::points;
}

bool lights_points(const PlannedPass& pass) {
    return pass.scope == PassScope::points;
}

/// The first pass that belongs, and those behind it that do without a gap.
std::span<const PlannedPass> find_stretch(std::span<const PlannedPass> passes, bool (*belongs)(const PlannedPass&)) {
    std::size_t first = 0;
    while (first < passes.size() && !belongs(passes[first])) ++first;
    std::size_t end = first;
    while (end < passes.size() && belongs(passes[end])) ++end;
    return passes.subspan(first, end - first);
}

/// Milliseconds of a stretch that threads shared, divided among its passes in proportion to what all threads together
/// spent in each.
void share_out(const Frame& frame, std::span<const PlannedPass> stretch, double ms, StageTimes& times) {
    std::vector<double> spent(stretch.size(), 0.0);
    for (std::size_t p = 0; p < stretch.size(); ++p) {
        const std::size_t number = number_of(frame, stretch[p]);
        for (const auto& scratch : frame.buffers.scratch) spent[p] += static_cast<double>(scratch->clock.spent[number]);
    }
    const double all = std::accumulate(spent.begin(), spent.end(), 0.0);
    for (std::size_t p = 0; p < stretch.size(); ++p) {
        const double share = all > 0.0 ? spent[p] / all : 1.0 / static_cast<double>(stretch.size());
        times.stages.emplace_back(stretch[p].name, ms * share);
        if (stretch[p].run == write_bytes) times.display_ms += ms * share;
    }
}

}  // namespace

std::span<const PlannedPass> tile_passes_of(const RenderPlan& plan) {
    const std::span<const PlannedPass> passes(plan.passes);
    const auto is_of_tile = [](const PlannedPass& pass) { return pass.scope == PassScope::tile; };
    return {std::find_if(passes.begin(), passes.end(), is_of_tile), passes.end()};
}

std::span<const PlannedPass> batch_passes_of(std::span<const PlannedPass> tile_passes) {
    return find_stretch(tile_passes, is_of_batch);
}

std::span<const PlannedPass> lighting_passes_of(const RenderPlan& plan) {
    return find_stretch(plan.passes, lights_points);
}

void walk_baking(const Frame& frame, StageTimes& times) {
    Stopwatch watch;
    for (const PlannedPass& pass : frame.plan.passes) {
        if (pass.scope != PassScope::once) continue;
        pass.run({frame, pass, *frame.buffers.scratch[0]});
        times.stages.emplace_back(pass.name, watch.lap_ms());
    }
}

void walk_frame(const Frame& frame, StageTimes& times) {
    Stopwatch watch;
    const std::span<const PlannedPass> passes(frame.plan.passes);
    const std::size_t tiles_begin = passes.size() - frame.tile_passes.size();
    for (std::size_t p = 0; p < tiles_begin;) {
        const std::size_t first = p++;
        if (passes[first].scope != PassScope::frame) continue;
        passes[first].run({frame, passes[first], *frame.buffers.scratch[0]});
        while (p < tiles_begin && lights_points(passes[p])) ++p;  // the pass before ran them, batch by batch
        share_out(frame, passes.subspan(first, p - first), watch.lap_ms(), times);
    }
    render_tiles(frame);
    share_out(frame, frame.tile_passes, watch.lap_ms(), times);
}

}  // namespace kreda::scene
