#include "scene/render/shade.hpp"

#include "scene/render/shadow_pass.hpp"

namespace kreda::scene {

namespace {

/// Lamps do not ask for ao, but a view may.
void show_constant_ao(int count, const lighting::MaterialSetup& surface, lighting::LightingChannels& channels) {
    if (surface.maps.ao.texture) return;
    for (int i = 0; i < count; ++i) channels.microfacet.ao.set(i, surface.material.cook_torrance.ao);
}

}  // namespace

void shade_points(const Frame& frame, const raster::Fragments& points, std::uint32_t material,
                  lighting::LightingChannels& channels) {
    const lighting::MaterialSetup& surface = frame.plan.materials[material];
    start_lighting(points, surface, frame.lighting, channels);
    if (frame.plan.lit_by_environment)
        add_environment(points, surface, frame.lighting.environment, channels);
    else if (!frame.plan.views.empty())
        show_constant_ao(points.count, surface, channels);
    if (surface.material.model != lighting::ReflectionModel::unlit) {
        using enum lighting::LeaveChannels;
        const bool has_views = !frame.plan.views.empty();
        // A view, or whoever stops at one point, looks at a light's quantities even where it adds nothing.
        const bool looked_at = has_views || points.count == 1;
        for (std::size_t k = 0; k < frame.lighting.lights.size(); ++k) {
            sample_light(points, frame.lighting.lights[k], channels);
            if (!looked_at && !any_faces_light(points.count, channels)) continue;
            if (find_shadow(frame, static_cast<int>(k), points, channels)) shadow_light(points.count, channels);
            add_reflection(points.count, surface, has_views ? always : only_of_batches, channels);
        }
    }
    sum_terms(points.count, channels);
}

}  // namespace kreda::scene
