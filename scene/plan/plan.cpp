#include "scene/plan/plan.hpp"

#include <algorithm>

#include "raster/platform.hpp"
#include "scene/map_meshes.hpp"
#include "scene/plan/environment_plan.hpp"
#include "scene/plan/list_passes.hpp"

namespace kreda::scene {

namespace {

/// The attributes of a vertex that a later pass reads.
raster::VertexNeeds vertex_needs(const Scene& scene, const RenderPlan& plan) {
    const bool lit_at_pixels = plan.frequency == ShadingFrequency::phong;
    const bool lit_at_vertices = plan.frequency == ShadingFrequency::gouraud;
    raster::VertexNeeds needs;
    needs.position_world = true;
    needs.normal_world = lit_at_pixels || lit_at_vertices;
    needs.color = lit_at_vertices;
    needs.color_behind = lit_at_vertices && plan.two_sided;
    needs.fog = plan.fog_at_vertices;
    for (const View* view : plan.views) {
        needs.normal_world |= view->needs.normal;
        needs.uv |= view->needs.uv;
    }
    const std::vector<bool> visible = visible_materials(scene);
    for (std::size_t m = 0; m < plan.materials.size(); ++m) {
        needs.uv |= visible[m] && plan.materials[m].map_needs.uv;
        needs.tangent_world |= visible[m] && plan.materials[m].map_needs.tangent;
    }
    if (scene.objects.empty()) needs = {};
    return needs;
}

raster::FragmentNeeds fragment_needs(const RenderPlan& plan) {
    raster::FragmentNeeds needs;
    needs.position = plan.frequency == ShadingFrequency::phong || plan.fog_at_pixels;
    needs.normal = plan.frequency == ShadingFrequency::phong;
    needs.face_normal = plan.frequency == ShadingFrequency::phong && !plan.shadows.empty() &&
                        plan.shadows[0].map.settings.method == shadows::ShadowMethod::map;
    needs.color = plan.frequency == ShadingFrequency::gouraud;
    needs.fog = plan.fog_at_vertices;
    needs.two_sided = plan.two_sided;
    for (const View* view : plan.views) {
        needs.position |= view->needs.position;
        needs.normal |= view->needs.normal;
        needs.uv |= view->needs.uv;
    }
    return needs;
}

/// Maps are read where the light is computed: at samples only with phong.
std::vector<raster::FragmentNeeds> fragment_needs_of_materials(const RenderPlan& plan) {
    std::vector<raster::FragmentNeeds> of_material(plan.materials.size(), plan.fragment);
    if (plan.frequency != ShadingFrequency::phong) return of_material;
    for (std::size_t m = 0; m < of_material.size(); ++m) {
        const lighting::MapNeeds& maps = plan.materials[m].map_needs;
        of_material[m].uv |= maps.uv;
        of_material[m].uv_steps |= maps.uv_steps;
        of_material[m].tangent |= maps.tangent;
    }
    return of_material;
}

void list_left_out(RenderPlan& plan) {
    const auto left_out = [&](bool absent, const char* name, const char* why_not) {
        if (absent) plan.left_out.push_back({name, why_not});
    };
    const bool no_fog = !plan.fog_at_pixels && !plan.fog_at_vertices;
    left_out(plan.frequency != ShadingFrequency::gouraud, "light vertices",
             "only shading.frequency = \"gouraud\" lights vertices");
    left_out(plan.frequency != ShadingFrequency::flat, "light triangles",
             "only shading.frequency = \"flat\" lights triangles");
    left_out(plan.frequency != ShadingFrequency::phong, "light pixels",
             "only shading.frequency = \"phong\" lights pixels");
    left_out(!finds_sides(plan), "sides",
             plan.two_sided ? "shading.frequency = \"flat\": a triangle's normal is that of its winding"
             : plan.cull == raster::CullMode::back ? "shading.cull = \"back\": no back is seen"
                                                   : "shading.two_sided = false: a back takes the light of its front");
    const bool no_maps = std::none_of(plan.passes.begin(), plan.passes.end(),
                                      [](const PlannedPass& pass) { return pass.name.starts_with("maps of "); });
    left_out(no_maps, "maps", "no visible material has a map that its model reads");
    left_out(!plan.environment.any(), "environment",
             "there is no [environment] that a lit material or the background shows");
    left_out(plan.environment.any() && !plan.environment.blurred, "prefiltered levels and brdf map",
             "no visible material is cook_torrance, or environment.reference integrates without them");
    left_out(no_fog, "fog", "fog.mode = \"none\"");
}

/// Lamps shine pi times as bright on the older models' diffuse as on the same albedo: said where both are seen.
void note_two_scales(const Scene& scene, RenderPlan& plan) {
    const std::vector<bool> visible = visible_materials(scene);
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

}  // namespace

RenderPlan make_plan(const Scene& scene, const std::vector<const View*>& views) {
    RenderPlan plan;
    plan.views = views;
    plan.has_lights = std::any_of(scene.lights.begin(), scene.lights.end(), [](const auto& light) { return light.on; });
    plan.samples = scene.image.samples;
    plan.viewport = {scene.image.width * plan.samples, scene.image.height * plan.samples};
    plan.cull = scene.shading.cull;
    plan.two_sided = scene.shading.two_sided && plan.cull != raster::CullMode::back;
    plan.interpolation = scene.shading.interpolation == Interpolation::affine
                             ? raster::AttributeInterpolation::affine
                             : raster::AttributeInterpolation::perspective;
    plan.frequency = scene.shading.frequency;
    const bool foggy = scene.fog.mode != lighting::FogMode::none && !scene.objects.empty();
    plan.fog_at_vertices = foggy && scene.fog.frequency == lighting::FogFrequency::vertex;
    plan.fog_at_pixels = foggy && scene.fog.frequency == lighting::FogFrequency::pixel;
    ShadowPlan shadow_plan = plan_shadows(scene, plan.frequency == ShadingFrequency::phong);
    plan.shadows = std::move(shadow_plan.shadows);
    plan.shadows_by_frame = !plan.shadows.empty() && is_frame_by_frame(scene.shadow.method);
    KREDA_EXPECT(!plan.shadows_by_frame || plan.frequency == ShadingFrequency::phong);
    plan.shows_blockers = std::any_of(views.begin(), views.end(), [](const View* view) {
        return view->name == "blocker_distance" || view->name == "penumbra";
    });
    for (const lighting::Material& material : scene.materials) plan.materials.push_back(prepare(material));
    plan.environment = environment_needs(scene);
    plan.lit_by_environment = plan.environment.irradiance || (scene.environment.on && scene.environment.reference > 0);
    plan.vertex = vertex_needs(scene, plan);
    plan.fragment = fragment_needs(plan);
    plan.fragment_of_material = fragment_needs_of_materials(plan);
    list_passes(scene, plan);
    list_left_out(plan);
    note_two_scales(scene, plan);
    if (plan.shadows.empty() && shadow_plan.why_not.empty()) {
        plan.left_out.push_back({"shadows", "no light that is on has shadow = true"});
    }
    for (const std::string& why_not : shadow_plan.why_not) plan.left_out.push_back({"shadows", why_not});
    return plan;
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
