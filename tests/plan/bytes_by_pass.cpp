#include "tests/plan/bytes_by_pass.hpp"

#include <algorithm>

#include "scene/environment.hpp"
#include "scene/plan/list_passes.hpp"
#include "scene/plan/pass_functions.hpp"
#include "scene/render/shadow_pass.hpp"
#include "scene/render/tile_pass.hpp"
#include "tests/plan/counted_memory.hpp"

namespace kreda::tests {

namespace {

using scene::PlannedPass;
using scene::RenderBuffers;

/// Move it out and let it go.
template <class Memory>
void give_back(Memory& memory) {
    const Memory gone = std::move(memory);
    memory = Memory{};
}

void give_back_vertices(raster::VertexStreams& streams) {
    give_back(streams.screen);
    give_back(streams.position_world);
    give_back(streams.normal_world);
    give_back(streams.uv);
    give_back(streams.tangent_world);
}

void give_back_shadow(RenderBuffers& buffers, const PlannedPass& pass, bool is_first) {
    give_back(buffers.shadows[static_cast<std::size_t>(pass.index)]);
    if (is_first) give_back(buffers.seen_by_light);
}

/// The maps that a baking pass made. No other frame holds them.
void give_back_maps(RenderBuffers& buffers, const PlannedPass& pass, bool makes_mirror) {
    auto& maps = const_cast<lighting::EnvironmentMaps&>(buffers.environment->maps);
    if (pass.run == scene::bake_cube) give_back(maps.light);
    if (makes_mirror) give_back(maps.prefiltered);
    if (pass.run == scene::bake_irradiance) give_back(maps.irradiance);
    if (pass.run == scene::bake_brdf) give_back(maps.brdf);
}

/// What belongs to the pass by what it is called to do.
void give_back_results(const scene::RenderPlan& plan, const PlannedPass& pass, RenderBuffers& buffers) {
    if (pass.run == scene::place_vertices) give_back_vertices(buffers.streams);
    if (pass.run == scene::fog_vertices) give_back(buffers.streams.fog);
    if (pass.run == scene::place_triangles) give_back(buffers.triangles.chunks);
    if (pass.run == scene::collect_visible_samples) give_back(buffers.visible);
    if (pass.run == scene::light_triangles) give_back(buffers.flat_color);
    if (pass.run == scene::light_vertices) {
        give_back(buffers.streams.color);
        give_back(buffers.streams.color_behind);
    }
    if (pass.run == scene::build_shadow || pass.run == scene::make_frame_shadow) {
        const auto first = std::find_if(plan.passes.begin(), plan.passes.end(),
                                        [&](const PlannedPass& other) { return other.run == pass.run; });
        give_back_shadow(buffers, pass, &*first == &pass);
    }
    if (pass.scope == scene::PassScope::once) {
        const bool is_cube = pass.run == scene::bake_cube, is_blurred = plan.environment.blurred;
        give_back_maps(buffers, pass, is_blurred ? pass.run == scene::bake_levels : is_cube);
    }
    if (pass.run == scene::show_depth || pass.run == scene::show_view) {
        give_back(buffers.views[static_cast<std::size_t>(pass.index)]);
    }
}

/// Channels of points belong to the first pass that works on them.
void give_back_channels(const scene::RenderPlan& plan, const PlannedPass& pass, RenderBuffers& buffers) {
    const auto first = std::find_if(plan.passes.begin(), plan.passes.end(), scene::works_on_points);
    const bool is_first = first != plan.passes.end() && &*first == &pass;
    const bool lights_background = pass.run == scene::start_background && plan.environment_background;
    for (auto& scratch : buffers.scratch) {
        if (is_first) scratch->fragments.reset();
        if (is_first || lights_background) scratch->lighting.reset();
    }
}

}  // namespace

std::vector<std::int64_t> give_back_by_pass(const scene::RenderPlan& plan, RenderBuffers& buffers) {
    std::vector<std::int64_t> bytes;
    for (const PlannedPass& pass : plan.passes) {
        const std::int64_t before = bytes_in_use();
        give_back_results(plan, pass, buffers);
        give_back_channels(plan, pass, buffers);
        if (&pass == &plan.passes.back()) {  // the film: its picture, and a tile of it for each thread
            give_back(buffers.film);
            give_back(buffers.bytes);
            give_back(buffers.scratch);
        }
        bytes.push_back(before - bytes_in_use());
    }
    return bytes;
}

}  // namespace kreda::tests
