#include "scene/render/render.hpp"

#if defined(_OPENMP)
#include <omp.h>
#endif

#include "scene/render/debug_pixel.hpp"
#include "scene/render/early_lighting.hpp"
#include "scene/render/frame_shadows.hpp"
#include "scene/render/shadow_pass.hpp"
#include "scene/render/sides.hpp"
#include "scene/render/stopwatch.hpp"
#include "scene/render/tile_pass.hpp"
#include "scene/render/visibility_check.hpp"

namespace kreda::scene {

namespace {

int thread_count() {
#if defined(_OPENMP)
    return omp_get_max_threads();
#else
    return 1;
#endif
}

int thread_number() {
#if defined(_OPENMP)
    return omp_get_thread_num();
#else
    return 0;
#endif
}

/// Sets the number of threads for the length of a frame.
class ThreadLimit {
public:
    explicit ThreadLimit(int threads) : before_(thread_count()) {
        set(threads > 0 ? threads : before_);
    }
    ~ThreadLimit() {
        set(before_);
    }
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    static void set([[maybe_unused]] int threads) {
#if defined(_OPENMP)
        omp_set_num_threads(threads);
#endif
    }
    int before_;
};

std::vector<raster::MeshInstance> make_instances(const Scene& scene) {
    std::vector<raster::MeshInstance> instances;
    for (const Object& object : scene.objects) {
        raster::MeshInstance instance;
        instance.mesh = object.mesh.get();
        instance.world_from_object = object.world_from_object;
        instance.part_material.assign(object.part_material.begin(), object.part_material.end());
        instance.part_hidden = object.part_hidden;
        instances.push_back(std::move(instance));
    }
    return instances;
}

std::vector<lighting::LightSetup> make_lights(const Scene& scene) {
    std::vector<lighting::LightSetup> lights;
    for (const lighting::Light& light : scene.lights) {
        if (light.on) lights.push_back(prepare(light));
    }
    return lights;
}

/// Baking belongs to loading, not to the frame.
void bake_if_missing(const Scene& scene, const RenderPlan& plan, RenderBuffers& buffers) {
    if (!plan.environment.any()) return;
    const auto usable = [&](const PreparedEnvironment* prepared) {
        return prepared && serves(*prepared, scene.environment, plan.environment);
    };
    if (usable(buffers.environment.get())) return;
    if (usable(scene.environment.prepared.get())) {
        buffers.environment = scene.environment.prepared;
        return;
    }
    buffers.environment =
        std::make_shared<PreparedEnvironment>(prepare_environment(scene.environment, plan.environment));
}

lighting::LightingSetup make_lighting(const Scene& scene, const RenderPlan& plan, const RenderBuffers& buffers,
                                      const std::vector<lighting::LightSetup>& lights) {
    lighting::LightingSetup setup;
    setup.eye = scene.camera.position;
    setup.forward = view_direction(scene.camera);
    setup.orthographic = scene.camera.projection == raster::Projection::orthographic;
    setup.ambient = scene.ambient;
    setup.lights = lights;
    if (plan.lit_by_environment || plan.environment.mirror) {
        setup.environment = environment_setup(scene.environment, *buffers.environment);
    }
    setup.fog = scene.fog;
    return setup;
}

/// One TileScratch a thread, times and counts at zero.
void prepare_scratch(RenderBuffers& buffers) {
    buffers.scratch.resize(static_cast<std::size_t>(thread_count()));
    for (std::unique_ptr<TileScratch>& scratch : buffers.scratch) {
        if (!scratch) scratch = std::make_unique<TileScratch>();
        scratch->visibility_ms = scratch->interpolation_ms = scratch->lighting_ms = scratch->film_ms = 0.0;
        scratch->samples_shaded = 0;
        scratch->color_is_background = false;
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
    prepare_picture(scene, 3, buffers.film);
    buffers.views.resize(plan.views.size());
    for (std::size_t v = 0; v < plan.views.size(); ++v) {
        prepare_picture(scene, plan.views[v]->components, buffers.views[v]);
    }
}

/// The tile with the pixel that a debugger wants to see is drawn first, so that nobody waits for the others; -1: there
/// is none.
int tile_to_debug(const Frame& frame) {
    if (debug_pixel.x < 0) return -1;
    const raster::TileGrid& grid = frame.buffers.triangles.grid;
    for (int t = 0; t < grid.columns * grid.rows; ++t) {
        if (sample_to_debug(tile_area(grid, frame.plan.viewport, t), frame.plan.samples).x >= 0) return t;
    }
    return -1;
}

void render_tiles(const Frame& frame) {
    const int tile_count = frame.buffers.triangles.grid.columns * frame.buffers.triangles.grid.rows;
    const std::vector<int>& order = frame.buffers.tile_order;
    const int first = tile_to_debug(frame);
    if (first >= 0) render_tile(frame, first, *frame.buffers.scratch[0]);
#pragma omp parallel for schedule(dynamic)
    for (int t = 0; t < tile_count; ++t) {
        const int tile = order.empty() ? t : order[static_cast<std::size_t>(t)];
        if (tile == first) continue;
        render_tile(frame, tile, *frame.buffers.scratch[static_cast<std::size_t>(thread_number())]);
    }
}

void add_tile_times(const RenderBuffers& buffers, RenderStatistics& statistics) {
    double visibility = 0.0, interpolation = 0.0, light = 0.0, film = 0.0;
    for (const std::unique_ptr<TileScratch>& scratch : buffers.scratch) {
        visibility += scratch->visibility_ms;
        interpolation += scratch->interpolation_ms;
        light += scratch->lighting_ms;
        film += scratch->film_ms;
        statistics.samples_shaded += scratch->samples_shaded;
    }
    const double threads = static_cast<double>(buffers.scratch.size());
    statistics.times.stages.emplace_back("visibility", visibility / threads);
    statistics.times.stages.emplace_back("interpolate", interpolation / threads);
    statistics.times.stages.emplace_back("shade", light / threads);
    statistics.times.stages.emplace_back("film", film / threads);
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
    bake_if_missing(scene, plan, buffers);
    RenderStatistics statistics;
    Stopwatch total;
    Stopwatch watch;
    const auto lap = [&](const char* stage) { statistics.times.stages.emplace_back(stage, watch.lap_ms()); };

    const float aspect = raster::aspect_of(scene.image.width, scene.image.height);
    const glm::mat4 clip_from_world = raster::clip_from_world(scene.camera, aspect);
    const std::vector<lighting::LightSetup> lights = make_lights(scene);
    const lighting::LightingSetup lighting = make_lighting(scene, plan, buffers, lights);
    buffers.instances = make_instances(scene);
    prepare_scratch(buffers);
    prepare_pictures(scene, plan, buffers);
    const Frame frame{scene, plan, lighting, buffers};

    lay_out_vertices(buffers.instances, plan.vertex, buffers.streams);
    transform_vertices(buffers.instances, clip_from_world, plan.viewport, buffers.streams);
    lap("vertices");
    if (!plan.shadows.empty() && !plan.shadows_by_frame) {
        prepare_shadows(frame);
        lap(scene.shadow.method == shadows::ShadowMethod::map ? "shadow maps" : "shadow tree");
    }
    if (plan.vertex.color) {
        light_vertices(frame);
        lap("light vertices");
    }
    if (plan.vertex.fog) {
        fog_vertices(frame);
        lap("fog vertices");
    }
    statistics.triangles = setup_triangles(buffers.instances, clip_from_world, plan.viewport, plan.cull, plan.samples,
                                           buffers.streams, buffers.triangles);
    lap("triangles");
    if (plan.two_sided) {
        find_sides(frame);
        lap("sides");
    }
    if (plan.shadows_by_frame) {
        find_frame_shadows(frame, clip_from_world);
        lap("shadows");
    }
    if (plan.frequency == ShadingFrequency::flat) {
        light_triangles(frame);
        lap("light triangles");
    }
    render_tiles(frame);
    add_tile_times(buffers, statistics);
    statistics.times.total_ms = total.lap_ms();
    check_visibility_if_asked(frame);
    look(frame);
    return statistics;
}

raster::Image render(const Scene& scene) {
    RenderBuffers buffers;
    render(scene, make_plan(scene), buffers);
    return std::move(buffers.film);
}

}  // namespace kreda::scene
