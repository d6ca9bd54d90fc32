#include "scene/plan/plan.hpp"

#include <algorithm>
#include <cstdio>

#include "lighting/batch/passes.hpp"
#include "raster/platform.hpp"
#include "scene/map_meshes.hpp"
#include "scene/plan/environment_plan.hpp"
#include "scene/plan/plan_cost.hpp"
#include "scene/plan/shadow_words.hpp"

namespace kreda::scene {

namespace {

/// Sizes of the scene that the plan's buffers depend on.
struct Sizes {
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    std::uint64_t pixels = 0;
};

Sizes measure(const Scene& scene) {
    Sizes sizes;
    for (const Object& object : scene.objects) {
        sizes.vertices += object.mesh->positions.size();
        sizes.triangles += object.mesh->triangle_count();
    }
    sizes.pixels = static_cast<std::uint64_t>(scene.image.width) * scene.image.height;
    return sizes;
}

raster::CullMode cull_mode(Cull cull) {
    switch (cull) {
        case Cull::back: return raster::CullMode::back;
        case Cull::front: return raster::CullMode::front;
        case Cull::none: return raster::CullMode::none;
    }
    return raster::CullMode::back;
}

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

void plan_vertices(const Scene& scene, const Sizes& sizes, RenderPlan& plan) {
    PlannedPass pass{
        "vertices", "object -> world -> clip -> screen for " + std::to_string(sizes.vertices) + " vertices", {}};
    pass.buffers.push_back({"screen", sizes.vertices * sizeof(raster::ScreenVertex)});
    if (plan.vertex.position_world) pass.buffers.push_back({"position_world", sizes.vertices * sizeof(glm::vec3)});
    if (plan.vertex.normal_world) pass.buffers.push_back({"normal_world", sizes.vertices * sizeof(glm::vec3)});
    if (plan.vertex.uv) pass.buffers.push_back({"uv", sizes.vertices * sizeof(glm::vec2)});
    if (plan.vertex.tangent_world) pass.buffers.push_back({"tangent_world", sizes.vertices * sizeof(glm::vec4)});
    plan.passes.push_back(pass);
    if (plan.frequency == ShadingFrequency::gouraud) {
        const std::string both_sides = plan.two_sided ? ", for both sides of the surface" : "";
        PlannedPass light{"light vertices",
                          "shading.frequency = \"gouraud\": " + std::to_string(scene.lights.size()) +
                              " lights at every vertex" + both_sides,
                          {{"color", sizes.vertices * sizeof(glm::vec3)}}};
        if (plan.two_sided) light.buffers.push_back({"color_behind", sizes.vertices * sizeof(glm::vec3)});
        plan.passes.push_back(light);
    }
    if (plan.fog_at_vertices) {
        plan.passes.push_back(
            {"fog at vertices", "fog.frequency = \"vertex\"", {{"fog", sizes.vertices * sizeof(float)}}});
    }
}

void plan_triangles(const Sizes& sizes, RenderPlan& plan) {
    const std::uint64_t bytes = sizes.triangles * (sizeof(raster::ScreenTriangle) + sizeof(std::uint16_t));
    plan.passes.push_back({"triangles",
                           "cull, clip and sort " + std::to_string(sizes.triangles) + " triangles into tiles",
                           {{"triangles and bins, at most", bytes}}});
    if (plan.two_sided) {
        plan.passes.push_back(
            {"sides", "shading.two_sided: a triangle seen from behind has its normals turned to the viewer", {}});
    }
    if (plan.frequency == ShadingFrequency::flat) {
        plan.passes.push_back({"light triangles",
                               "shading.frequency = \"flat\": once a triangle, at its centroid",
                               {{"flat color", sizes.triangles * sizeof(glm::vec3)}}});
    }
}

void plan_shadow_passes(const Scene& scene, RenderPlan& plan) {
    for (const PlannedShadow& shadow : plan.shadows) plan.passes.push_back(pass_of(scene, shadow, plan.viewport));
}

const char* where_lit(ShadingFrequency frequency) {
    switch (frequency) {
        case ShadingFrequency::flat: return "at every triangle's centroid";
        case ShadingFrequency::gouraud: return "at every vertex";
        case ShadingFrequency::phong: return "at every sample";
    }
    return "";
}

void plan_tiles(const Scene& scene, RenderPlan& plan) {
    plan.passes.push_back({"visibility",
                           "which triangle is nearest, sample by sample",
                           {{"depth and triangle of one tile, a thread", sizeof(raster::TileVisibility)}}});
    if (plan.fragment.any()) {
        plan.passes.push_back(
            {"interpolate",
             std::string("attributes between the vertices, ") +
                 (plan.interpolation == raster::AttributeInterpolation::affine ? "affine" : "perspective-correct"),
             {{"fragments of one batch, a thread", sizeof(raster::Fragments)}}});
    }
    if (plan.frequency == ShadingFrequency::phong) {
        plan.passes.push_back(
            {"light pixels",
             "shading.frequency = \"phong\": " + std::to_string(scene.lights.size()) + " lights at every sample",
             {{"lighting channels of one batch, a thread", sizeof(lighting::LightingChannels)}}});
    }
    if (plan.lit_by_environment) {
        plan.passes.push_back({"environment",
                               scene.environment.reference > 0
                                   ? std::to_string(scene.environment.reference) +
                                         " samples of the integral in each of three ways " + where_lit(plan.frequency)
                                   : std::string("the split sum ") + where_lit(plan.frequency),
                               {}});
    }
    if (plan.fog_at_pixels) plan.passes.push_back({"fog at pixels", "fog.frequency = \"pixel\"", {}});
    if (plan.fog_at_vertices || plan.fog_at_pixels) {
        plan.passes.push_back({"mix fog", "fog.mode is not \"none\"", {}});
    }
}

const char* filter_name(lighting::TextureFilter filter) {
    switch (filter) {
        case lighting::TextureFilter::nearest: return "nearest";
        case lighting::TextureFilter::bilinear: return "bilinear";
        case lighting::TextureFilter::trilinear: return "trilinear";
    }
    return "";
}

/// One pass a material with maps.
void plan_maps(const Scene& scene, RenderPlan& plan) {
    const std::vector<bool> visible = visible_materials(scene);
    for (std::size_t m = 0; m < plan.materials.size(); ++m) {
        const lighting::MaterialMaps& maps = plan.materials[m].maps;
        if (!visible[m] || !plan.materials[m].map_needs.uv) continue;
        PlannedPass pass{"maps of " + scene.materials[m].name, "", {}};
        for (const lighting::MapUse& use : lighting::map_uses()) {
            const raster::Texture* texture = (maps.*use.map).texture.get();
            if (!texture) continue;
            const std::string size = std::to_string(texture->width) + " x " + std::to_string(texture->height);
            pass.reason += (pass.reason.empty() ? "" : ", ") + std::string(use.name) + "_map";
            pass.buffers.push_back(
                {std::string(use.name) + " " + size + ", levels " + std::to_string(texture->level_count),
                 texture->texels.size() * sizeof(float)});
        }
        pass.reason += std::string(" read ") + where_lit(plan.frequency) + ", " + filter_name(maps.filter);
        plan.passes.push_back(pass);
    }
}

void plan_film(const Scene& scene, const Sizes& sizes, RenderPlan& plan) {
    const int n = scene.image.samples;
    const std::string reason = n == 1 ? "one sample a pixel" : "mean of " + std::to_string(n * n) + " samples a pixel";
    plan.passes.push_back({"film", reason, {{"linear RGB", sizes.pixels * 3 * sizeof(float)}}});
    for (const View* view : plan.views) {
        const std::uint64_t bytes = sizes.pixels * static_cast<std::uint64_t>(view->components) * sizeof(float);
        plan.passes.push_back({"view " + std::string(view->name), std::string(view->meaning), {{"values", bytes}}});
    }
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
    left_out(!plan.two_sided, "sides",
             plan.cull == raster::CullMode::back ? "shading.cull = \"back\": no back is seen"
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
    const Sizes sizes = measure(scene);
    RenderPlan plan;
    plan.views = views;
    plan.has_lights = std::any_of(scene.lights.begin(), scene.lights.end(), [](const auto& light) { return light.on; });
    plan.samples = scene.image.samples;
    plan.viewport = {scene.image.width * plan.samples, scene.image.height * plan.samples};
    plan.cull = cull_mode(scene.shading.cull);
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
    plan.passes = plan_baking(scene, plan.environment);
    if (!scene.objects.empty()) {
        plan_maps(scene, plan);
        plan_vertices(scene, sizes, plan);
        if (!plan.shadows_by_frame) plan_shadow_passes(scene, plan);
        plan_triangles(sizes, plan);
        if (plan.shadows_by_frame) plan_shadow_passes(scene, plan);
        plan_tiles(scene, plan);
    }
    plan_film(scene, sizes, plan);
    estimate_costs(scene, plan);
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

namespace {

/// "1.25 billion"
std::string short_count(double count) {
    const bool billions = count >= 1e9, millions = count >= 1e6;
    char text[40];
    std::snprintf(text, sizeof text, "%.3g", billions ? count * 1e-9 : millions ? count * 1e-6 : count);
    return std::string(text) + (billions ? " billion" : millions ? " million" : "");
}

std::string cost_line(const PassCost& cost) {
    if (cost.items.empty()) return "";
    const bool upper_bound = cost.items == "samples";
    char each[32];
    std::snprintf(each, sizeof each, "%.0f", cost.operations_each);
    return std::string("     cost: ") + (upper_bound ? "at most " : "") + std::to_string(cost.count) + " " +
           cost.items + " x " + each + " operations = " + short_count(cost.operations()) + "\n";
}

}  // namespace

std::string describe(const RenderPlan& plan, bool with_left_out) {
    std::string text;
    int number = 1;
    for (const PlannedPass& pass : plan.passes) {
        text += std::to_string(number++) + ". " + pass.name + ": " + pass.reason + "\n";
        for (const PlannedBuffer& buffer : pass.buffers) {
            text += "     " + buffer.name + ": " + std::to_string(buffer.bytes) + " bytes\n";
        }
        text += cost_line(pass.cost);
    }
    const bool all_estimated = std::all_of(plan.passes.begin(), plan.passes.end(), [](const PlannedPass& pass) {
        return !pass.cost.items.empty() || pass.name.starts_with("view ");
    });
    const double bake_operations = baking_operations(plan);
    if (bake_operations > 0.0) { text += "baking, once and kept: " + short_count(bake_operations) + " operations\n"; }
    text += std::string(bake_operations > 0.0 ? "a frame" : "together") + ": at most " +
            short_count(total_operations(plan)) + " operations" +
            (all_estimated ? "" : " and those of the passes without an estimate") + ", " +
            std::to_string(total_bytes(plan)) + " bytes of buffers\n";
    if (with_left_out) {
        for (const LeftOutPass& pass : plan.left_out) text += "-  " + pass.name + ": left out, " + pass.why_not + "\n";
    }
    for (const std::string& note : plan.notes) text += "note: " + note + "\n";
    return text;
}

}  // namespace kreda::scene
