#include "scene/plan/needs.hpp"

#include <algorithm>

namespace kreda::scene {

namespace {

bool has_shadow_maps(const RenderPlan& plan) {
    return !plan.shadows.empty() && plan.shadows[0].map.settings.method == shadows::ShadowMethod::map;
}

bool is_lit_by_lamps(const RenderPlan& plan, std::size_t m) {
    return std::any_of(plan.lighting.lamps.begin(), plan.lighting.lamps.end(),
                       [&](const MaterialMask& lamp) { return lamp[m]; });
}

/// A lamp at a place, or one with a shadow, asks where the point lies; light from infinitely far away does not.
bool is_lit_from_a_place(const Scene& scene, const RenderPlan& plan, std::size_t m) {
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        const auto is_its = [&](const PlannedShadow& shadow) { return shadow.light == static_cast<int>(k); };
        const bool asks = scene.lights[k].type != lighting::LightType::directional ||
                          std::any_of(plan.shadows.begin(), plan.shadows.end(), is_its);
        if (plan.lighting.lamps[k][m] && asks) return true;
    }
    return false;
}

/// What light at one sample reads: the position for v and for lamps, the normal for n, and what maps are read by.
raster::FragmentNeeds lit_sample_needs(const Scene& scene, const RenderPlan& plan, std::size_t m) {
    const bool surface = plan.lighting.surface[m] || !plan.seen, maps = plan.lighting.maps[m];
    const bool same_view = plan.seen && scene.camera.projection == raster::Projection::orthographic;
    const lighting::MapNeeds& read = plan.materials[m].map_needs;
    raster::FragmentNeeds needs;
    needs.position = plan.wanted.position && ((surface && !same_view) || is_lit_from_a_place(scene, plan, m));
    needs.face_normal = (surface || is_lit_by_lamps(plan, m)) && has_shadow_maps(plan);
    needs.normal = surface || needs.face_normal;  // it says which side of the face is outside
    needs.uv = maps && read.uv;
    needs.uv_steps = maps && read.uv_steps;
    needs.tangent = maps && surface && read.tangent;
    return needs;
}

void add_views(const RenderPlan& plan, raster::FragmentNeeds& needs) {
    for (const View* view : plan.views) {
        needs.position |= view->needs.position;
        needs.normal |= view->needs.normal;
        needs.uv |= view->needs.uv;
    }
}

}  // namespace

raster::FragmentNeeds join(const std::vector<raster::FragmentNeeds>& of_material) {
    raster::FragmentNeeds all;
    for (const raster::FragmentNeeds& needs : of_material) {
        all.position |= needs.position;
        all.normal |= needs.normal;
        all.face_normal |= needs.face_normal;
        all.color |= needs.color;
        all.uv |= needs.uv;
        all.uv_steps |= needs.uv_steps;
        all.tangent |= needs.tangent;
        all.fog |= needs.fog;
        all.two_sided |= needs.two_sided;
    }
    return all;
}

std::vector<raster::FragmentNeeds> fragment_needs(const Scene& scene, const RenderPlan& plan) {
    std::vector<raster::FragmentNeeds> of_material(plan.materials.size());
    for (std::size_t m = 0; m < of_material.size(); ++m) {
        if (!plan.lighting.seen[m]) continue;
        raster::FragmentNeeds& needs = of_material[m];
        if (plan.frequency == ShadingFrequency::phong) needs = lit_sample_needs(scene, plan, m);
        needs.position |= plan.fog_at_pixels;
        needs.color = plan.frequency == ShadingFrequency::gouraud && plan.wanted.radiance;
        needs.fog = plan.fog_at_vertices;
        add_views(plan, needs);
        needs.two_sided = plan.two_sided;
    }
    return of_material;
}

raster::VertexNeeds vertex_needs(const RenderPlan& plan) {
    const raster::FragmentNeeds& fragment = plan.fragment;
    const bool early = plan.frequency != ShadingFrequency::phong;
    const bool lit_early = early && plan.wanted.radiance && any_of(plan.lighting.surface);
    const bool at_vertices = plan.frequency == ShadingFrequency::gouraud;
    raster::VertexNeeds needs;
    if (!plan.draws_objects) return needs;
    const bool all = !plan.seen;  // somebody may look at it
    needs.normal_world =
        (all && (at_vertices || !early)) || fragment.normal || (lit_early && at_vertices) || plan.finds_sides;
    needs.position_world = all || fragment.position || fragment.face_normal || lit_early || plan.fog_at_vertices ||
                           plan.finds_sides || !plan.shadows.empty() || (early && !at_vertices && plan.wanted.radiance);
    needs.color = at_vertices && plan.wanted.radiance;
    needs.color_behind = needs.color && plan.two_sided;
    needs.fog = plan.fog_at_vertices;
    needs.uv = fragment.uv;
    needs.tangent_world = fragment.tangent;
    for (std::size_t m = 0; m < plan.materials.size() && early; ++m) {
        needs.uv |= plan.lighting.maps[m] && plan.materials[m].map_needs.uv;
        needs.tangent_world |= plan.lighting.maps[m] && plan.materials[m].map_needs.tangent;
    }
    return needs;
}

}  // namespace kreda::scene
