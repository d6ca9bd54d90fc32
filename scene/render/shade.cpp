#include "scene/render/shade.hpp"

#include "lighting/batch/environment_passes.hpp"
#include "scene/plan/pass_functions.hpp"
#include "scene/render/pass_work.hpp"
#include "scene/render/shadow_pass.hpp"

namespace kreda::scene {

namespace {

const lighting::MaterialSetup& surface_of(const PassWork& work) {
    return work.frame.plan.materials[work.material];
}

/// A view, or whoever stops at one point, looks at a light's quantities even where it adds nothing.
bool is_looked_at(const PassWork& work) {
    return !work.frame.plan.views.empty() || work.points->count == 1;
}

/// Lamps do not ask for ao, but a view may.
void show_constant_ao(int count, const lighting::MaterialSetup& surface, lighting::LightingChannels& channels) {
    if (surface.maps.ao.texture) return;
    for (int i = 0; i < count; ++i) channels.microfacet.ao.set(i, surface.material.cook_torrance.ao);
}

}  // namespace

void shade_points(const Frame& frame, const raster::Fragments& points, std::uint32_t material,
                  lighting::LightingChannels& channels, TileScratch& scratch) {
    const lighting::MaterialSetup& surface = frame.plan.materials[material];
    lighting::start_surface(surface, frame.lighting, channels);
    if (!frame.plan.lit_by_environment && !frame.plan.views.empty()) show_constant_ao(points.count, surface, channels);
    scratch.clock.lap(frame.pass_that_lights);
    for (const PlannedPass& pass : frame.lighting_passes) {
        if (!works_on(pass, material)) continue;
        pass.run({.frame = frame,
                  .pass = pass,
                  .scratch = scratch,
                  .material = material,
                  .points = &points,
                  .channels = &channels});
        scratch.clock.lap(number_of(frame, pass));
    }
    lighting::sum_terms(points.count, channels);
}

void look_up_maps(const PassWork& work) {
    lighting::apply_maps(*work.points, surface_of(work), *work.channels);
}

void set_surface(const PassWork& work) {
    lighting::set_directions(*work.points, surface_of(work), work.frame.lighting, *work.channels);
}

void add_environment(const PassWork& work) {
    using enum lighting::LeaveChannels;
    lighting::add_environment(*work.points, surface_of(work), work.frame.lighting.environment,
                              is_looked_at(work) ? always : only_of_batches, *work.channels);
}

void add_light(const PassWork& work) {
    const Frame& frame = work.frame;
    const int count = work.points->count;
    const bool has_views = !frame.plan.views.empty();
    lighting::sample_light(*work.points, frame.lighting.lights[static_cast<std::size_t>(work.pass.index)],
                           *work.channels);
    if (!is_looked_at(work) && !lighting::any_faces_light(count, *work.channels)) return;
    if (set_shadow(frame, work.pass.index, *work.points, *work.channels)) {
        lighting::shadow_light(count, *work.channels);
    }
    using enum lighting::LeaveChannels;
    const bool is_last = static_cast<std::size_t>(work.pass.index) + 1 == frame.lighting.lights.size();
    const lighting::LeaveChannels without_views = is_last ? only_radiance : only_of_batches;
    lighting::add_reflection(count, surface_of(work), has_views ? always : without_views, *work.channels);
}

}  // namespace kreda::scene
