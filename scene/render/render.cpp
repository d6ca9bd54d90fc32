#include "scene/render/render.hpp"

#include <algorithm>

#include "scene/instances.hpp"
#include "scene/plan/pass_functions.hpp"
#include "scene/render/debug_pixel.hpp"
#include "scene/render/frame_done.hpp"
#include "scene/render/shadow_pass.hpp"
#include "scene/render/stopwatch.hpp"
#include "scene/render/threads.hpp"
#include "scene/render/tile_pass.hpp"
#include "scene/render/walk_passes.hpp"

namespace kreda::scene {

namespace {

std::vector<lighting::LightSetup> make_lights(const Scene& scene) {
    std::vector<lighting::LightSetup> lights;
    for (const lighting::Light& light : scene.lights) {
        if (light.on) lights.push_back(prepare(light));
    }
    return lights;
}

/// What the passes find where nothing was baked: they need not ask.
lighting::EnvironmentMaps black_maps(const RenderPlan& plan) {
    lighting::EnvironmentMaps maps;
    if (plan.environment.mirror || plan.environment.blurred) maps.prefiltered = lighting::make_cube_map({1});
    if (plan.environment.irradiance) maps.irradiance = lighting::make_cube_map({1});
    for (const lighting::BrdfKind& kind : plan.environment.brdf) {
        const std::size_t texels = std::size_t{4} * lighting::kBrdfMapSize * lighting::kBrdfMapSize;
        maps.brdf.push_back({kind.distribution, kind.geometry, std::vector<float>(texels, 0.0f)});
    }
    return maps;
}

/// Take the maps that are there, or make the passes bake them.
void begin_baking(const Scene& scene, const RenderPlan& plan, RenderBuffers& buffers) {
    const auto usable = [&](const PreparedEnvironment* prepared) {
        return prepared && serves(*prepared, scene.environment, plan.environment);
    };
    if (!plan.environment.any() || usable(buffers.environment.get())) return;
    if (usable(scene.environment.prepared.get())) {
        buffers.environment = scene.environment.prepared;
        return;
    }
    const EnvironmentSettings& settings = scene.environment;
    buffers.baking = std::make_unique<Baking>();
    buffers.baking->prepared = std::make_shared<PreparedEnvironment>(
        PreparedEnvironment{settings.image, settings.sky, settings.samples, plan.environment, black_maps(plan)});
}

void end_baking(const Scene& scene, RenderBuffers& buffers) {
    if (!buffers.baking) return;
    add_light_table(scene.environment, buffers.baking->prepared->maps);
    buffers.environment = std::move(buffers.baking->prepared);
    buffers.baking.reset();
}

lighting::LightingSetup make_lighting(const Scene& scene, const RenderPlan& plan, const RenderBuffers& buffers,
                                      const std::vector<lighting::LightSetup>& lights) {
    lighting::LightingSetup setup;
    setup.eye = scene.camera.position;
    setup.forward = view_direction(scene.camera);
    setup.orthographic = scene.camera.projection == raster::Projection::orthographic;
    setup.ambient = scene.ambient;
    setup.lights = lights;
    if (plan.environment.any()) { setup.environment = environment_setup(scene.environment, *buffers.environment); }
    setup.fog = scene.fog;
    return setup;
}

/// One TileScratch a thread, times and counts at zero.
void fit_scratch(const RenderPlan& plan, RenderBuffers& buffers) {
    buffers.scratch.resize(static_cast<std::size_t>(thread_count()));
    for (std::unique_ptr<TileScratch>& scratch : buffers.scratch) {
        if (!scratch) scratch = std::make_unique<TileScratch>();
        fit_scratch(plan, *scratch);
    }
}

/// Size a picture without touching memory that is there already: every pixel is written by its tile.
void prepare_picture(const Scene& scene, int channels, raster::Image& picture) {
    picture.width = scene.image.width;
    picture.height = scene.image.height;
    picture.channels = channels;
    picture.values.resize(picture.plane_size() * static_cast<std::size_t>(channels));
}

void prepare_pictures(const Scene& scene, const RenderPlan& plan, RenderBuffers& buffers) {
    if (plan.film && !plan.bytes) prepare_picture(scene, 3, buffers.film);
    if (plan.bytes) {
        const std::size_t pixels = static_cast<std::size_t>(scene.image.width) * scene.image.height;
        buffers.bytes = {scene.image.width, scene.image.height, 3, std::move(buffers.bytes.values)};
        buffers.bytes.values.resize(3 * pixels);
    }
    buffers.views.resize(plan.views.size());
    for (std::size_t v = 0; v < plan.views.size(); ++v) {
        prepare_picture(scene, plan.views[v]->components, buffers.views[v]);
    }
}

/// What the frame before left of a shadow goes where the plan has that shadow now.
void arrange_kept(const RenderPlan& plan, RenderBuffers& buffers) {
    std::vector<ShadowMemory>& kept = buffers.shadows;
    for (const PlannedPass& pass : plan.passes) {
        if (pass.run != build_shadow || pass.inputs.empty()) continue;
        const auto place = static_cast<std::size_t>(pass.index);
        if (place < kept.size() && kept[place].inputs == pass.inputs) continue;
        const auto found = std::find_if(kept.begin(), kept.end(),
                                        [&](const ShadowMemory& memory) { return memory.inputs == pass.inputs; });
        if (found == kept.end()) continue;
        if (place >= kept.size()) {
            const auto number = found - kept.begin();
            kept.resize(place + 1);
            std::swap(kept[place], kept[static_cast<std::size_t>(number)]);
        } else {
            std::swap(kept[place], *found);
        }
    }
}

/// Everything that the passes write has its place before the first of them runs.
void prepare_buffers(const Scene& scene, const RenderPlan& plan, RenderBuffers& buffers) {
    buffers.instances = make_instances(scene);
    if (plan.draws_objects) lay_out_vertices(buffers.instances, plan.vertex, buffers.streams);
    buffers.triangles.grid = raster::make_tile_grid(plan.viewport, plan.samples);
    buffers.triangles.chunks.resize(plan.draws_objects ? buffers.triangles.chunks.size() : 0);
    if (buffers.keeps_results) arrange_kept(plan, buffers);
    buffers.shadows.resize(plan.shadows.size());
    prepare_pictures(scene, plan, buffers);
}

std::size_t pass_that_lights(const RenderPlan& plan) {
    const auto lights = [](const PlannedPass& pass) {
        return pass.run == light_samples || pass.run == light_vertices || pass.run == light_triangles;
    };
    const auto found = std::find_if(plan.passes.begin(), plan.passes.end(), lights);
    return static_cast<std::size_t>(found - plan.passes.begin());
}

}  // namespace

RenderBuffers::RenderBuffers() = default;
RenderBuffers::~RenderBuffers() = default;
RenderBuffers::RenderBuffers(RenderBuffers&&) noexcept = default;
RenderBuffers& RenderBuffers::operator=(RenderBuffers&&) noexcept = default;

RenderStatistics render(const Scene& scene, const RenderPlan& plan, RenderBuffers& buffers, int threads) {
    return render(scene, plan, buffers, threads, [](const Frame&) {});
}

RenderStatistics render(const Scene& scene, const RenderPlan& plan, RenderBuffers& buffers, int threads,
                        const std::function<void(const Frame&)>& look) {
    picture_begins(scene.image.width, scene.image.height);
    const ThreadLimit limit(threads);
    RenderStatistics statistics;
    lighting::LightingSetup lighting;
    fit_scratch(plan, buffers);
    const Frame frame{scene,
                      plan,
                      lighting,
                      buffers,
                      statistics,
                      raster::clip_from_world(scene.camera, raster::aspect_of(scene.image.width, scene.image.height)),
                      tile_passes_of(plan),
                      lighting_passes_of(plan),
                      pass_that_lights(plan)};
    begin_baking(scene, plan, buffers);
    walk_baking(frame, statistics.times);
    end_baking(scene, buffers);

    Stopwatch total;
    const std::vector<lighting::LightSetup> lights = make_lights(scene);
    lighting = make_lighting(scene, plan, buffers, lights);
    prepare_buffers(scene, plan, buffers);
    walk_frame(frame, statistics.times);
    for (const std::unique_ptr<TileScratch>& scratch : buffers.scratch) {
        statistics.samples_shaded += scratch->samples_shaded;
        add(scratch->shown, statistics.shown);
    }
    statistics.times.total_ms = total.lap_ms() - statistics.times.display_ms;
    look(frame);
    frame_done(frame);
    return statistics;
}

raster::Image render(const Scene& scene) {
    RenderBuffers buffers;
    render(scene, make_plan(scene), buffers);
    return std::move(buffers.film);
}

}  // namespace kreda::scene
