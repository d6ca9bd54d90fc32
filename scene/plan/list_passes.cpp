#include "scene/plan/list_passes.hpp"

#include <algorithm>

#include "raster/shading_points.hpp"
#include "scene/plan/environment_plan.hpp"
#include "scene/plan/pass_functions.hpp"
#include "scene/plan/pass_inputs.hpp"
#include "scene/plan/plan_cost.hpp"
#include "scene/plan/shadow_words.hpp"
#include "shadows/visible_sample_memory.hpp"

namespace kreda::scene {

namespace {

/// What the functions below read, and the list that they add to.
struct Listing {
    const Scene& scene;
    const RenderPlan& plan;
    PlanCounts counts;
    std::vector<PlannedPass> passes;

    PlannedPass& add(PassScope scope, void (*run)(const PassWork&), std::string name, std::string reason,
                     PassCost cost) {
        passes.push_back({std::move(name), std::move(reason), {}, std::move(cost), scope, run});
        return passes.back();
    }
};

constexpr const char* kAsTheLights = "as for the lights that ask for it";

void list_vertices(Listing& list) {
    const raster::VertexNeeds& needs = list.plan.vertex;
    const std::uint64_t count = list.counts.vertices;
    PlannedPass& pass = list.add(PassScope::frame, place_vertices, "vertices",
                                 "object -> world -> clip -> screen for " + std::to_string(count) + " vertices",
                                 vertex_cost(list.plan, list.counts));
    pass.buffers.push_back({"screen", count * sizeof(raster::ScreenVertex)});
    if (needs.position_world) pass.buffers.push_back({"position_world", count * sizeof(glm::vec3)});
    if (needs.normal_world) pass.buffers.push_back({"normal_world", count * sizeof(glm::vec3)});
    if (needs.uv) pass.buffers.push_back({"uv", count * sizeof(glm::vec2)});
    if (needs.tangent_world) pass.buffers.push_back({"tangent_world", count * sizeof(glm::vec4)});
}

void list_vertex_fog(Listing& list) {
    list.add(PassScope::frame, fog_vertices, "fog at vertices", "fog.frequency = \"vertex\"",
             vertex_fog_cost(list.scene, list.counts))
        .buffers = {{"fog", list.counts.vertices * sizeof(float)}};
}

std::size_t largest_mesh(const Scene& scene) {
    std::size_t most = 0;
    for (const Object& object : scene.objects) most = std::max<std::size_t>(most, object.mesh->triangle_count());
    return most;
}

void list_triangles(Listing& list) {
    const std::uint64_t count = list.counts.triangles;
    list.add(PassScope::frame, place_triangles, "triangles",
             "cull, clip and sort " + std::to_string(count) + " triangles into tiles", triangle_cost(list.counts))
        .buffers = {
        {list.plan.seen ? "triangles and bins" : "triangles and bins, at most", list.counts.drawn * kTriangleBytes},
        {"those of one chunk, a thread, while it runs", raster::bytes_to_set_up(largest_mesh(list.scene))}};
    if (!list.plan.finds_sides) return;
    list.add(PassScope::frame, judge_sides, "sides",
             "shading.two_sided, and normals that contradict the winding: which side of a triangle is seen",
             side_cost(list.counts));
}

/// Maps are drawn one after the other, in memory that is as large as the largest of them needs.
void add_memory_of_maps(Listing& list) {
    std::uint64_t most = 0;
    for (const PlannedShadow& shadow : list.plan.shadows) { most = std::max(most, bytes_to_draw(list.scene, shadow)); }
    const auto first = std::find_if(list.passes.begin(), list.passes.end(),
                                    [](const PlannedPass& pass) { return pass.run == build_shadow; });
    if (most > 0) first->buffers.push_back({"vertices and triangles of the casters, at most", most});
}

void list_shadows(Listing& list) {
    const auto number = [](const PlannedShadow& shadow, const RenderPlan& plan) {
        return static_cast<int>(&shadow - plan.shadows.data());
    };
    if (list.plan.shadows_by_frame) {
        constexpr std::uint64_t kSample = sizeof(float) + sizeof(glm::vec3) + sizeof(std::uint32_t);
        list.add(PassScope::frame, collect_visible_samples, "visible samples",
                 "shadow.method looks at all samples that are seen, before any is lit", visibility_cost(list.counts))
            .buffers = {{"depth, position and triangle", list.counts.samples * kSample},
                        {"one tile, a thread, while it runs", shadows::bytes_to_find_visible()}};
        if (list.plan.seen) list.passes.back().bound = "as for the shadows that ask for it";
    }
    for (const PlannedShadow& shadow : list.plan.shadows) {
        PlannedPass pass = pass_of(list.scene, shadow, list.plan.viewport);
        pass.scope = PassScope::frame;
        pass.run = list.plan.shadows_by_frame ? make_frame_shadow : build_shadow;
        pass.index = number(shadow, list.plan);
        if (!list.plan.shadows_by_frame) pass.inputs = shadow_inputs(list.scene, shadow);
        if (list.plan.seen) pass.bound = "whether anything that is seen lies in it is known once it is there";
        list.passes.push_back(std::move(pass));
    }
    add_memory_of_maps(list);
}

const char* where_lit(ShadingFrequency frequency) {
    switch (frequency) {
        case ShadingFrequency::flat: return "at every triangle's centroid";
        case ShadingFrequency::gouraud: return "at every vertex";
        case ShadingFrequency::phong: return "at every sample";
    }
    return "";
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
void list_maps(Listing& list) {
    for (std::size_t m = 0; m < list.plan.materials.size(); ++m) {
        const lighting::MaterialMaps& maps = list.plan.materials[m].maps;
        if (!list.plan.lighting.maps[m]) continue;
        std::string names;
        std::vector<PlannedBuffer> buffers;
        for (const lighting::MapUse& use : lighting::map_uses()) {
            const raster::Texture* texture = (maps.*use.map).texture.get();
            if (!texture) continue;
            const std::string size = std::to_string(texture->width) + " x " + std::to_string(texture->height);
            names += (names.empty() ? "" : ", ") + std::string(use.name) + "_map";
            buffers.push_back({std::string(use.name) + " " + size + ", levels " + std::to_string(texture->level_count),
                               texture->texels.size() * sizeof(float)});
        }
        PlannedPass& pass =
            list.add(PassScope::points, look_up_maps, "maps of " + list.scene.materials[m].name,
                     names + " read " + where_lit(list.plan.frequency) + ", " + filter_name(maps.filter),
                     map_cost(list.plan, list.counts, buffers.size()));
        pass.buffers = std::move(buffers);
        pass.index = static_cast<int>(m);
        pass.materials.assign(list.plan.materials.size(), false);
        pass.materials[m] = true;
        if (list.plan.seen && is_lit(list.scene.materials[m])) pass.bound = kAsTheLights;
    }
}

std::string environment_reason(const Scene& scene, const RenderPlan& plan) {
    const int reference = scene.environment.reference;
    const std::string how = reference > 0
                                ? std::to_string(reference) + " samples of the integral in each of three ways "
                                : std::string("the split sum ");
    return how + where_lit(plan.frequency);
}

void list_lights(Listing& list) {
    int number = -1;
    for (std::size_t i = 0; i < list.scene.lights.size(); ++i) {
        const lighting::Light& light = list.scene.lights[i];
        number += light.on;
        if (!any_of(list.plan.lighting.lamps[i])) continue;
        const bool casts = std::any_of(list.plan.shadows.begin(), list.plan.shadows.end(),
                                       [&](const PlannedShadow& s) { return s.light == static_cast<int>(i); });
        PlannedPass& pass = list.add(PassScope::points, add_light, name_of_light(light, i),
                                     std::string("on: what it sends") + (casts ? ", its shadow" : "") +
                                         " and what is reflected of it " + where_lit(list.plan.frequency),
                                     light_cost(list.scene, list.plan, list.counts, static_cast<int>(i)));
        pass.index = number;
        pass.materials = list.plan.lighting.lamps[i];
        if (list.plan.seen)
            pass.bound = "whether a seen sample faces it out of the shadow, and reflects it, is not asked before";
    }
}

/// What light is, wherever it is computed: the passes of the lecture's equation.
void list_lighting(Listing& list) {
    const LightingChoices& chosen = list.plan.lighting;
    list_maps(list);
    if (any_of(chosen.surface)) {
        PlannedPass& pass =
            list.add(PassScope::points, set_surface, "surface",
                     std::string("n and v ") + where_lit(list.plan.frequency), surface_cost(list.plan, list.counts));
        pass.materials = chosen.surface;
        if (list.plan.seen && !list.plan.lit_by_environment) pass.bound = kAsTheLights;
    }
    if (list.plan.lit_by_environment) {
        list.add(PassScope::points, add_environment, "environment", environment_reason(list.scene, list.plan),
                 environment_light_cost(list.scene, list.plan, list.counts))
            .materials = chosen.environment;
    }
    list_lights(list);
}

/// Colours that are computed before anything is drawn lie in memory that begins black.
constexpr const char* kMayBeBlack = "whether what is seen is black anyway is known once it is lit";

/// The pass that lights, and behind it what it runs at every batch of points.
PlannedPass& list_lit(Listing& list, PassScope scope, void (*run)(const PassWork&), const std::string& name,
                      const std::string& reason) {
    const std::size_t number = list.passes.size();
    list.add(scope, run, name, reason, sum_cost(list.plan, list.counts));
    list_lighting(list);
    return list.passes[number];
}

void list_lit_vertices(Listing& list) {
    const std::uint64_t bytes = list.counts.vertices * sizeof(glm::vec3);
    PlannedPass& pass = list_lit(list, PassScope::frame, light_vertices, "light vertices",
                                 std::string("shading.frequency = \"gouraud\": what follows, at every vertex") +
                                     (list.plan.two_sided ? ", for both sides of the surface" : ""));
    pass.buffers = {{"color", bytes}};
    if (list.plan.seen) pass.bound = kMayBeBlack;
    if (list.plan.two_sided) pass.buffers.push_back({"color_behind", bytes});
}

void list_lit_triangles(Listing& list) {
    PlannedPass& pass = list_lit(list, PassScope::frame, light_triangles, "light triangles",
                                 "shading.frequency = \"flat\": what follows, once a triangle, at its centroid");
    pass.buffers = {{"flat color", list.counts.drawn * sizeof(glm::vec3)}};
    if (list.plan.seen) pass.bound = kMayBeBlack;
}

void list_lit_samples(Listing& list) {
    list_lit(list, PassScope::batch, light_samples, "light pixels",
             "shading.frequency = \"phong\": what follows, at every sample");
}

/// Flat shading in clear air has nothing left to compute at a pixel.
bool only_painting_left(const RenderPlan& plan) {
    const bool fog = plan.fog_at_pixels || plan.fog_at_vertices;
    return plan.frequency == ShadingFrequency::flat && plan.film && !fog && plan.views.empty();
}

bool interpolates(const RenderPlan& plan) {
    return plan.shadows_by_frame || std::any_of(plan.fragment_of_material.begin(), plan.fragment_of_material.end(),
                                                [](const raster::FragmentNeeds& needs) { return needs.any(); });
}

/// Nothing but lamps reads what is interpolated.
bool only_lamps_ask(const RenderPlan& plan) {
    const bool fog = plan.fog_at_pixels || plan.fog_at_vertices;
    const auto shows_a_map = [&](std::size_t m) { return plan.lighting.maps[m] && !plan.lighting.surface[m]; };
    if (!plan.seen || plan.frequency != ShadingFrequency::phong || fog || plan.lit_by_environment) return false;
    for (std::size_t m = 0; m < plan.materials.size(); ++m) {
        if (shows_a_map(m)) return false;
    }
    return std::all_of(plan.views.begin(), plan.views.end(), [](const View* view) { return !view->needs.any(); });
}

void list_fog(Listing& list) {
    if (list.plan.fog_at_pixels) {
        list.add(PassScope::batch, fog_samples, "fog at pixels", "fog.frequency = \"pixel\"",
                 fog_cost(list.scene, list.plan, list.counts));
    }
    if (list.plan.fog_at_vertices || list.plan.fog_at_pixels) {
        if (!list.plan.wanted.radiance) return;
        list.add(PassScope::batch, mix_fog, "mix fog", "fog.mode is not \"none\"",
                 mix_fog_cost(list.plan, list.counts));
    }
}

void list_visible(Listing& list) {
    list.add(PassScope::tile, find_nearest, "visibility", "which triangle is nearest, sample by sample",
             visibility_cost(list.counts));
}

std::string samples_of_block(const RenderPlan& plan) {
    const std::string side = std::to_string(plan.shading_rate);
    return side + " x " + side + " samples";
}

/// Before the batches: which samples are lit.
void list_shading_points(Listing& list) {
    if (list.plan.shading_rate == 1) return;
    PlannedPass& pass = list.add(PassScope::tile, choose_shading_points, "shading points",
                                 "shading.rate: one point of each triangle is lit for " + samples_of_block(list.plan),
                                 copy_cost(list.counts));
    pass.buffers = {{"the point of every sample of one tile, a thread", sizeof(raster::ShadingPoints)}};
    if (list.plan.seen) pass.bound = "whether samples of a block differ is known once they are lit";
}

/// Behind them: the other samples get what their point has.
void list_spreading(Listing& list) {
    if (list.plan.shading_rate == 1) return;
    list.add(PassScope::tile, spread_points, "spread", "what a point has to all " + samples_of_block(list.plan),
             copy_cost(list.counts));
    if (list.plan.seen) list.passes.back().bound = "whether two samples of a block see one triangle is not asked";
}

/// From the attributes of the visible samples to their radiance in the tile.
void list_batches(Listing& list) {
    if (only_painting_left(list.plan)) {
        list.add(PassScope::tile, paint_flat, "paint", "the colour of its triangle at every sample",
                 copy_cost(list.counts));
        return;
    }
    if (interpolates(list.plan)) {
        const bool affine = list.plan.interpolation == raster::AttributeInterpolation::affine;
        list.add(PassScope::batch, interpolate, "interpolate",
                 std::string("attributes between the vertices, ") + (affine ? "affine" : "perspective-correct"),
                 interpolation_cost(list.plan, list.counts));
        if (only_lamps_ask(list.plan)) list.passes.back().bound = kAsTheLights;
        if (list.plan.seen && list.plan.vertex.color) list.passes.back().bound = kMayBeBlack;
    }
    if (list.plan.frequency == ShadingFrequency::flat && list.plan.wanted.radiance) {
        list.add(PassScope::batch, color_flat, "flat color", "the colour of its triangle at every sample",
                 copy_cost(list.counts));
        if (list.plan.seen) list.passes.back().bound = "whether fog hides it all is known once it is there";
    }
    if (list.plan.frequency == ShadingFrequency::phong && list.plan.lighting.any) list_lit_samples(list);
    list_fog(list);
    if (!list.plan.film) return;
    list.add(PassScope::batch, paint, "paint", "the radiance of a batch to its places in the tile",
             copy_cost(list.counts));
}

/// Depth and triangle of each sample, the runs of what is seen, and three numbers of colour.
constexpr std::uint64_t bytes_of_tile() {
    constexpr std::uint64_t kSamples = std::uint64_t{raster::kTileSide} * raster::kTileSide;
    return sizeof(raster::TileVisibility) + kSamples * (sizeof(raster::Run) + 3 * sizeof(float));
}

std::vector<PlannedBuffer> view_buffers(const Listing& list, const View& view) {
    return {{"values", list.counts.pixels * static_cast<std::uint64_t>(view.components) * sizeof(float)}};
}

/// depth: the views of the depth buffer, or those of the batches' channels.
void list_views(Listing& list, bool depth) {
    for (std::size_t v = 0; v < list.plan.views.size(); ++v) {
        const View& view = *list.plan.views[v];
        const bool of_depth = !view.value;
        if (of_depth != depth) continue;
        PlannedPass& pass =
            list.add(of_depth ? PassScope::tile : PassScope::batch, of_depth ? show_depth : show_view,
                     "view " + std::string(view.name), std::string(view.meaning), copy_cost(list.counts));
        pass.buffers = view_buffers(list, view);
        pass.index = static_cast<int>(v);
    }
}

void list_background(Listing& list) {
    list.add(PassScope::tile, start_background, "background",
             list.plan.environment_background ? "image.background = \"environment\": where nothing is drawn"
                                              : "image.background: one colour where nothing is drawn",
             copy_cost(list.counts));
}

void list_film(Listing& list) {
    const int n = list.scene.image.samples;
    const bool bytes = list.plan.bytes;
    std::string how = n == 1 ? "one sample a pixel" : "mean of " + std::to_string(n * n) + " samples a pixel";
    if (bytes) how += ", tone-mapped and encoded in its tile";
    PlannedPass& pass =
        list.add(PassScope::tile, bytes ? write_bytes : write_film, "film", how, film_cost(list.plan, list.counts));
    if (bytes) pass.buffers = {{"8-bit RGB", list.counts.pixels * 3}};
    if (list.plan.film && !bytes) pass.buffers = {{"linear RGB", list.counts.pixels * 3 * sizeof(float)}};
    pass.buffers.push_back({"depth, triangles and colours of one tile, a thread", bytes_of_tile()});
}

void list_objects(Listing& list) {
    const RenderPlan& plan = list.plan;
    list_vertices(list);
    if (!plan.shadows_by_frame) list_shadows(list);
    if (plan.vertex.color) list_lit_vertices(list);
    if (plan.fog_at_vertices) list_vertex_fog(list);
    list_triangles(list);
    if (plan.shadows_by_frame) list_shadows(list);
    if (plan.frequency == ShadingFrequency::flat && plan.wanted.radiance) list_lit_triangles(list);
}

/// Memory of a thread, listed where the first pass is that needs it.
void add_memory_of_threads(Listing& list) {
    constexpr std::uint64_t kPoints = sizeof(raster::Fragments), kLight = sizeof(lighting::LightingChannels);
    const auto first = std::find_if(list.passes.begin(), list.passes.end(), works_on_points);
    const auto background = std::find_if(list.passes.begin(), list.passes.end(),
                                         [](const PlannedPass& pass) { return pass.run == start_background; });
    if (first != list.passes.end()) first->buffers.push_back({"points of one batch, a thread", kPoints});
    const auto lit = list.plan.environment_background ? std::min(first, background) : first;
    if (lit != list.passes.end()) lit->buffers.push_back({"lighting channels of one batch, a thread", kLight});
}

}  // namespace

bool works_on_points(const PlannedPass& pass) {
    return pass.scope == PassScope::batch || pass.scope == PassScope::points || pass.run == light_vertices ||
           pass.run == light_triangles || pass.run == fog_vertices;
}

void list_passes(const Scene& scene, RenderPlan& plan) {
    Listing list{scene, plan, count(scene, plan), plan_baking(scene, plan.environment)};
    for (PlannedPass& pass : list.passes) {
        if (plan.seen && !plan.wanted.effects) pass.bound = "which of the baked maps the view reads is not asked";
    }
    const bool objects = plan.draws_objects;
    if (objects) list_objects(list);
    if (objects) list_visible(list);
    if (plan.shows_background) list_background(list);
    if (objects) list_views(list, true);
    if (objects) list_shading_points(list);
    if (objects) list_batches(list);
    if (objects) list_views(list, false);
    if (objects) list_spreading(list);
    list_film(list);
    add_memory_of_threads(list);
    plan.passes = std::move(list.passes);
}

}  // namespace kreda::scene
