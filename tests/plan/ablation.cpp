#include "tests/plan/ablation.hpp"

#include <cstring>
#include <limits>
#include <memory>
#include <type_traits>

#include "scene/render/tile_pass.hpp"

namespace kreda::tests {

namespace {

using scene::RenderPlan;
using scene::Scene;

/// A pass that is left out leaves its memory as it was. Filled with a number that no pass computes, that shows, even
/// where it would have written 0.
constexpr float kUnwritten = -12345.0f;

void fill(scene::TileColor& color) {
    for (float(&plane)[raster::kTileSide * raster::kTileSide] : color.plane) {
        for (float& value : plane) value = kUnwritten;
    }
}

void fill(const Scene& scene, int channels, raster::Image& image) {
    image = raster::make_image(scene.image.width, scene.image.height, channels);
    std::fill(image.values.begin(), image.values.end(), kUnwritten);
}

/// The channels of a batch are numbers and nothing else.
template <class Channels>
void fill_channels(Channels& channels) {
    static_assert(std::is_trivially_copyable_v<Channels> && sizeof(Channels) % sizeof(float) == 0);
    std::vector<float> numbers(sizeof(Channels) / sizeof(float), kUnwritten);
    std::memcpy(static_cast<void*>(&channels), numbers.data(), sizeof(Channels));
}

/// A frame's memory, everything that ends in the picture filled.
void fill(const Scene& scene, const RenderPlan& plan, scene::RenderBuffers& buffers) {
    buffers.scratch.resize(1);
    buffers.scratch[0] = std::make_unique<scene::TileScratch>();
    fit_scratch(plan, *buffers.scratch[0]);
    fill(buffers.scratch[0]->color);
    for (scene::TileColor& view : buffers.scratch[0]->views) fill(view);
    if (lighting::LightingChannels* const channels = buffers.scratch[0]->lighting.get()) fill_channels(*channels);
    if (raster::Fragments* const points = buffers.scratch[0]->fragments.get()) {
        fill_channels(*points);
        std::fill(std::begin(points->sample), std::end(points->sample), 0u);
    }
    if (plan.film) fill(scene, 3, buffers.film);
    buffers.views.resize(plan.views.size());
    for (std::size_t v = 0; v < plan.views.size(); ++v) fill(scene, plan.views[v]->components, buffers.views[v]);
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

/// All values that the frame leaves: the film's and the views'. What was baked stays in the scene where it is kept.
std::vector<float> draw(const Scene& scene, const RenderPlan& plan, Scene* keep = nullptr) {
    scene::RenderBuffers buffers;
    fill(scene, plan, buffers);
    render(scene, plan, buffers, 1);
    if (keep) keep->environment.prepared = buffers.environment;
    std::vector<float> values;
    if (plan.film) values.assign(buffers.film.values.begin(), buffers.film.values.end());
    for (const raster::Image& view : buffers.views) values.insert(values.end(), view.values.begin(), view.values.end());
    return values;
}

}  // namespace

void ablate(const Scene& scene, const scene::PlanRequest& request, const std::string& name, AblationReport& report) {
    const RenderPlan plan = make_plan_for(scene, request);
    Scene baked = scene;
    const std::vector<float> picture = draw(scene, plan, &baked);
    for (std::size_t p = 0; p < plan.passes.size(); ++p) {
        RenderPlan without = plan;
        without.passes.erase(without.passes.begin() + static_cast<std::ptrdiff_t>(p));
        ++report.passes;
        const bool bakes = plan.passes[p].scope == scene::PassScope::once;
        if (!same_bits(draw(bakes ? scene : baked, without), picture)) continue;
        if (plan.passes[p].bound.empty())
            report.useless.push_back(name + ": " + plan.passes[p].name);
        else
            report.idle.push_back(name + ": " + plan.passes[p].name);
    }
    scene::PlanRequest all = request;
    all.prune = false;
    if (!same_bits(draw(scene, make_plan_for(scene, all)), picture)) report.missing.push_back(name);
}

}  // namespace kreda::tests
