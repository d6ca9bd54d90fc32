#include "scene/plan/plan.hpp"

#include <algorithm>

#include "raster/platform.hpp"
#include "scene/plan/environment_plan.hpp"
#include "scene/plan/left_out.hpp"
#include "scene/plan/list_passes.hpp"
#include "scene/plan/needs.hpp"

namespace kreda::scene {

namespace {

/// Lamps shine pi times as bright on the older models' diffuse as on the same albedo: said where both are seen.
void note_two_scales(const Scene& scene, RenderPlan& plan) {
    const MaterialMask& visible = plan.lighting.seen;
    const std::string *per_pi = nullptr, *plain = nullptr;
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        const lighting::ReflectionModel model = scene.materials[m].model;
        if (!visible[m] || model == lighting::ReflectionModel::unlit) continue;
        const std::string*& name = model == lighting::ReflectionModel::cook_torrance ? per_pi : plain;
        if (!name) name = &scene.materials[m].name;
    }
    if (!plan.has_lights || !per_pi || !plain) return;
    plan.notes.push_back("\"" + *per_pi + "\" is cook_torrance and reflects albedo / pi of a lamp's light, \"" +
                         *plain +
                         "\" reflects diffuse: equal numbers look 3.14 times as bright there (docs/21_lambert.md)");
}

/// What the scene's settings say, whatever is seen.
RenderPlan start_plan(const Scene& scene, const PlanRequest& request) {
    RenderPlan plan;
    plan.views = request.views;
    plan.film = request.film;
    plan.bytes = request.film && request.bytes && request.views.empty();
    plan.wanted = wanted_of(request);
    plan.has_lights = std::any_of(scene.lights.begin(), scene.lights.end(), [](const auto& light) { return light.on; });
    plan.samples = scene.image.samples;
    plan.viewport = {scene.image.width * plan.samples, scene.image.height * plan.samples};
    plan.cull = scene.shading.cull;
    plan.two_sided = scene.shading.two_sided && plan.cull != raster::CullMode::back;
    plan.interpolation = scene.shading.interpolation == Interpolation::affine
                             ? raster::AttributeInterpolation::affine
                             : raster::AttributeInterpolation::perspective;
    plan.frequency = scene.shading.frequency;
    plan.shows_blockers = std::any_of(plan.views.begin(), plan.views.end(), [](const View* view) {
        return view->name == "blocker_distance" || view->name == "penumbra";
    });
    return plan;
}

/// Which maps each material reads; what its model computes once follows for those that are seen.
void start_materials(const Scene& scene, RenderPlan& plan) {
    for (const lighting::Material& material : scene.materials) {
        lighting::MaterialSetup setup;
        setup.material = material;
        setup.maps = lighting::maps_in_use(material);
        setup.map_needs = lighting::needs_of(setup.maps);
        plan.materials.push_back(std::move(setup));
    }
}

/// Is a view there for anything that is seen? The depth buffer is for all of it.
bool shows_anything(const RenderPlan& plan, const View& view) {
    for (std::size_t m = 0; m < plan.materials.size(); ++m) {
        if (plan.lighting.seen[m] && (!view.value || view.holds(plan, static_cast<std::uint32_t>(m)))) return true;
    }
    return false;
}

/// Objects that are seen, and of which nothing is asked for, are not drawn.
void leave_unasked_objects(const Scene& scene, RenderPlan& plan) {
    const bool asked = plan.film || std::any_of(plan.views.begin(), plan.views.end(),
                                                [&](const View* view) { return shows_anything(plan, *view); });
    if (!plan.seen || (asked && plan.seen->covered > 0)) return;
    plan.draws_objects = false;
    plan.lighting = nothing_lit(scene);
    plan.shadows.clear();
    plan.shadows_by_frame = plan.fog_at_vertices = plan.fog_at_pixels = plan.lit_by_environment = false;
    if (!plan.environment_background) plan.environment = {};
}

void choose_materials(const Scene& scene, RenderPlan& plan) {
    plan.lighting = choose_lighting(scene, plan.seen ? &*plan.seen : nullptr, plan.wanted);
    plan.draws_objects = plan.seen ? plan.seen->covered > 0 : !scene.objects.empty();
    for (std::size_t m = 0; m < plan.materials.size(); ++m) {
        if (plan.lighting.seen[m] && plan.lighting.any) plan.materials[m] = prepare(scene.materials[m]);
    }
}

/// Fog that leaves everything clear is none: a factor of exactly 1 changes no bit. A factor of 1 at every vertex is not
/// exactly 1 between them.
bool fog_is_clear(const Scene& scene, const Seen& seen) {
    constexpr float kRounding = 1.0001f;
    if (scene.fog.frequency == lighting::FogFrequency::vertex) return false;
    if (scene.fog.mode == lighting::FogMode::linear) return seen.farthest * kRounding < scene.fog.start;
    return scene.fog.density == 0.0f;
}

void choose_fog(const Scene& scene, RenderPlan& plan) {
    const bool foggy = scene.fog.mode != lighting::FogMode::none && plan.draws_objects && plan.wanted.fog;
    const bool looked_at = !plan.seen || !plan.wanted.effects;
    if (!foggy || (!looked_at && fog_is_clear(scene, *plan.seen))) return;
    plan.fog_at_vertices = scene.fog.frequency == lighting::FogFrequency::vertex;
    plan.fog_at_pixels = scene.fog.frequency == lighting::FogFrequency::pixel;
}

/// A view of shadows looks at those of one light: the last that has one.
void keep_last_shadow(RenderPlan& plan) {
    if (!plan.wanted.last_shadow || plan.wanted.lamps || plan.shadows.empty()) return;
    const PlannedShadow last = plan.shadows.back();
    for (std::size_t k = 0; k < plan.lighting.lamps.size(); ++k) {
        if (static_cast<int>(k) != last.light) plan.lighting.lamps[k].assign(plan.materials.size(), false);
    }
    plan.shadows = {last};
}

/// Shadows of the lights that are added to something. Returns why other lights have none.
std::vector<std::string> choose_shadows(const Scene& scene, RenderPlan& plan) {
    std::vector<bool> shines;
    for (const MaterialMask& lamp : plan.lighting.lamps) shines.push_back(plan.wanted.shadows && any_of(lamp));
    ShadowPlan shadow_plan = plan_shadows(scene, plan.frequency == ShadingFrequency::phong, shines);
    plan.shadows = std::move(shadow_plan.shadows);
    keep_last_shadow(plan);
    plan.shadows_by_frame = !plan.shadows.empty() && is_frame_by_frame(scene.shadow.method);
    KREDA_EXPECT(!plan.shadows_by_frame || plan.frequency == ShadingFrequency::phong);
    return std::move(shadow_plan.why_not);
}

bool is_written_everywhere(const RenderPlan& plan, const View& view) {
    for (std::size_t m = 0; m < plan.materials.size(); ++m) {
        const bool written = !view.value || view.holds(plan, static_cast<std::uint32_t>(m));
        if (plan.lighting.seen[m] && !written) return false;
    }
    return true;
}

/// Are there samples that show no object?
bool has_gaps(const RenderPlan& plan) {
    const std::uint64_t samples =
        static_cast<std::uint64_t>(plan.viewport.width) * static_cast<std::uint64_t>(plan.viewport.height);
    return !plan.draws_objects || !plan.seen || plan.seen->covered < samples;
}

void choose_background(RenderPlan& plan) {
    const auto needs_background = [&](const View* view) {
        const bool is_depth = !view->value;  // where nothing is drawn, the depth buffer says so itself
        return (has_gaps(plan) && (!is_depth || !plan.draws_objects)) || !is_written_everywhere(plan, *view);
    };
    plan.shows_background =
        (plan.film && has_gaps(plan)) || std::any_of(plan.views.begin(), plan.views.end(), needs_background);
}

void choose_environment(const Scene& scene, RenderPlan& plan) {
    plan.background = scene.image.environment_background ? glm::vec3(0.0f) : scene.image.background;
    if (!scene.environment.on) return;
    const bool background = scene.image.environment_background && plan.film && has_gaps(plan) &&
                            (!plan.seen || scene.environment.intensity != 0.0f);
    plan.environment_background = background;
    const bool looked_at = !plan.seen || !plan.wanted.effects;
    plan.environment = environment_needs(scene, plan.lighting.environment, background, looked_at);
    plan.lit_by_environment = plan.lighting.lit_by_environment();
}

/// What a material is and how a surface lies is shown at every sample; what light does there, where it is lit.
void choose_shading_rate(const Scene& scene, RenderPlan& plan) {
    const Wanted& wanted = plan.wanted;
    const bool light = wanted.radiance || wanted.environment || wanted.lamps || wanted.last_lamp || wanted.last_shadow;
    const bool lit = plan.frequency == ShadingFrequency::phong && plan.lighting.any;
    if (light && lit) plan.shading_rate = scene.shading.rate;
}

}  // namespace

LoadingPlan plan_loading(const Scene& scene, const PlanRequest& request) {
    RenderPlan plan = start_plan(scene, request);
    start_materials(scene, plan);
    LoadingPlan loading{look_at(scene, plan), {}};
    loading.maps = choose_lighting(scene, &loading.seen, plan.wanted).maps;
    return loading;
}

RenderPlan make_plan_for(const Scene& scene, const PlanRequest& request) {
    RenderPlan plan = start_plan(scene, request);
    start_materials(scene, plan);
    if (request.prune) plan.seen = request.seen ? *request.seen : look_at(scene, plan);
    choose_materials(scene, plan);
    choose_fog(scene, plan);
    const std::vector<std::string> no_shadows = choose_shadows(scene, plan);
    choose_environment(scene, plan);
    leave_unasked_objects(scene, plan);
    choose_background(plan);
    choose_shading_rate(scene, plan);
    const bool sides = plan.two_sided && plan.frequency != ShadingFrequency::flat && plan.lighting.any;
    plan.finds_sides = sides && any_of(plan.lighting.surface) && (!plan.seen || plan.seen->any_turned);
    plan.fragment_of_material = fragment_needs(scene, plan);
    plan.fragment = join(plan.fragment_of_material);
    plan.vertex = vertex_needs(plan);
    list_passes(scene, plan);
    list_left_out(scene, no_shadows, plan);
    note_two_scales(scene, plan);
    return plan;
}

RenderPlan make_plan(const Scene& scene, const std::vector<const View*>& views) {
    return make_plan_for(scene, {.views = views, .film = true, .prune = views.empty()});
}

bool can_show(const RenderPlan& plan, const Scene& scene, const View& view) {
    for (const Object& object : scene.objects) {
        for (std::size_t part = 0; part < object.part_material.size(); ++part) {
            if (object.part_hidden[part]) continue;
            if (view.holds(plan, static_cast<std::uint32_t>(object.part_material[part]))) return true;
        }
    }
    return false;
}

}  // namespace kreda::scene
