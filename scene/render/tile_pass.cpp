#include "scene/render/tile_pass.hpp"

#include <algorithm>

#include "raster/copy_past_cache.hpp"
#include "raster/platform.hpp"
#include "scene/plan/list_passes.hpp"
#include "scene/plan/pass_functions.hpp"
#include "scene/render/background.hpp"
#include "scene/render/debug_pixel.hpp"
#include "scene/render/pass_work.hpp"
#include "scene/render/threads.hpp"
#include "scene/render/walk_passes.hpp"

namespace kreda::scene {

namespace {

using raster::kTileSide;
using raster::Run;
using raster::TileArea;

/// Runs of one material stand together afterwards; within a material they keep their order.
void group_by_material(Run* runs, int count) {
    if (count == 0) return;
    const auto other_material = [&](const Run& run) { return run.material != runs[0].material; };
    if (std::none_of(runs, runs + count, other_material)) return;
    std::stable_sort(runs, runs + count, [](const Run& a, const Run& b) { return a.material < b.material; });
}

/// How many of the runs fit into one batch: one material, at most kBatchCapacity samples.
int runs_of_one_batch(const Run* runs, int count) {
    int samples = 0;
    int taken = 0;
    while (taken < count && runs[taken].material == runs[0].material &&
           samples + runs[taken].count <= raster::kBatchCapacity) {
        samples += runs[taken++].count;
    }
    return taken;
}

/// Flat shading in clear air: a run has its triangle's colour, and that is all.
KREDA_BATCH_LOOP void paint_flat_runs(const RenderBuffers& buffers, const Run* runs, int count, TileColor& color) {
    for (int r = 0; r < count; ++r) {
        const glm::vec3 radiance = flat_color_of(buffers, runs[r].triangle);
        const int first = runs[r].y * kTileSide + runs[r].x;
        for (int i = first; i < first + runs[r].count; ++i) {
            color.plane[0][i] = radiance.x;
            color.plane[1][i] = radiance.y;
            color.plane[2][i] = radiance.z;
        }
    }
}

void fill_background(const glm::vec3& background, TileColor& color) {
    for (int c = 0; c < 3; ++c) std::fill(std::begin(color.plane[c]), std::end(color.plane[c]), background[c]);
}

/// What is seen where nothing is drawn.
void start_color(const Frame& frame, const TileArea& area, TileScratch& scratch) {
    if (!frame.plan.environment_background) {
        if (!scratch.color_is_background) fill_background(frame.plan.background, scratch.color);
        return;
    }
    const ViewRays rays = view_rays(frame.scene.camera, frame.plan.viewport);
    float* const planes[3] = {scratch.color.plane[0], scratch.color.plane[1], scratch.color.plane[2]};
    look_past_tile(rays, frame.lighting.environment, area, scratch.lighting->environment, planes);
}

/// One pixel is the mean of its n x n samples, added row by row, left to right.
float mean_of_samples(const float* plane, int x, int y, int n) {
    float sum = 0.0f;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) sum += plane[(y * n + j) * kTileSide + x * n + i];
    }
    return sum / static_cast<float>(n * n);
}

/// One row of the tile's pixels: its samples, or the means of n x n of them, which `means` has room for.
const float* pixel_row(const float* plane, int y, int width, int n, float* means) {
    if (n == 1) return plane + y * kTileSide;
    for (int x = 0; x < width; ++x) means[x] = mean_of_samples(plane, x, y, n);
    return means;
}

/// Tile -> picture: copy, or average the samples of each pixel.
void write_picture(const TileArea& area, int n, const TileColor& color, raster::Image& picture) {
    const int width = area.width / n;
    float means[kTileSide];
    for (int c = 0; c < picture.channels; ++c) {
        for (int y = 0; y < area.height / n; ++y) {
            float* row = picture.plane(c) + static_cast<std::size_t>(area.y / n + y) * picture.width + area.x / n;
            raster::copy_past_cache(pixel_row(color.plane[c], y, width, n, means), width, row);
        }
    }
}

int samples_of(const Run* runs, int count) {
    int samples = 0;
    for (int r = 0; r < count; ++r) samples += runs[r].count;
    return samples;
}

/// Run batch by batch what follows each other in the list: one batch goes through all of these passes before the next.
void walk_batches(const Frame& frame, const TileArea& area, std::span<const PlannedPass> passes, const Run* runs,
                  int run_count, TileScratch& scratch) {
    for (int done = 0; done < run_count;) {
        const int count = runs_of_one_batch(runs + done, run_count - done);
        work_batch(frame, area, passes, runs + done, count, scratch);
        done += count;
    }
}

/// Where the wanted sample's colour is computed: there, or at the point that is lit in its place.
glm::ivec2 lit_in_place_of(const glm::ivec2& wanted, const TileScratch& scratch) {
    const int sample = wanted.y * kTileSide + wanted.x;
    if (wanted.x < 0 || !scratch.points_are_chosen) return wanted;
    const int point = scratch.points->of[sample];
    return {point % kTileSide, point / kTileSide};
}

/// All runs of the tile; the sample that a debugger wants to see in a batch of its own.
void walk_runs(const Frame& frame, const TileArea& area, std::span<const PlannedPass> passes, TileScratch& scratch) {
    Run* const runs = scratch.runs;
    group_by_material(runs, scratch.run_count);
    const glm::ivec2 wanted = lit_in_place_of(sample_to_debug(area, frame.plan.samples), scratch);
    if (wanted.x < 0) return walk_batches(frame, area, passes, runs, scratch.run_count, scratch);

    const int debugged = cut_out_sample(runs, scratch.run_count, wanted);
    walk_batches(frame, area, passes, runs, debugged, scratch);
    if (debugged == scratch.run_count) return pixel_not_covered(debug_pixel.x, debug_pixel.y);
    pixel_reached(debug_pixel.x, debug_pixel.y);
    walk_batches(frame, area, passes, runs + debugged, 1, scratch);
    walk_batches(frame, area, passes, runs + debugged + 1, scratch.run_count - debugged - 1, scratch);
}

}  // namespace

void work_batch(const Frame& frame, const TileArea& area, std::span<const PlannedPass> passes, const Run* runs,
                int count, TileScratch& scratch) {
    scratch.fragments->count = samples_of(runs, count);
    for (const PlannedPass& pass : passes) {
        if (pass.scope != PassScope::batch || !works_on(pass, runs[0].material)) continue;
        pass.run({frame, pass, scratch, area, runs, count, runs[0].material});
        scratch.clock.lap(number_of(frame, pass));
    }
}

void render_tile(const Frame& frame, int tile_index, TileScratch& scratch) {
    scratch.clock.start();
    const TileArea area = tile_area(frame.buffers.triangles.grid, frame.plan.viewport, tile_index);
    scratch.run_count = 0;
    scratch.points_are_chosen = false;
    const std::span<const PlannedPass> passes = frame.tile_passes;
    for (std::size_t p = 0; p < passes.size();) {
        if (passes[p].scope == PassScope::tile) {
            passes[p].run({frame, passes[p], scratch, area});
            scratch.clock.lap(number_of(frame, passes[p++]));
        } else {
            const std::span<const PlannedPass> batch = batch_passes_of(passes.subspan(p));
            walk_runs(frame, area, batch, scratch);
            p += batch.size();
        }
    }
}

namespace {

/// The number of the tile with the pixel that a debugger wants to see; -1 if there is none. It is drawn before all
/// others, so that the debugger stops at once.
int tile_to_debug(const Frame& frame) {
    if (debug_pixel.x < 0) return -1;
    const raster::TileGrid& grid = frame.buffers.triangles.grid;
    for (int t = 0; t < grid.columns * grid.rows; ++t) {
        if (sample_to_debug(tile_area(grid, frame.plan.viewport, t), frame.plan.samples).x >= 0) return t;
    }
    return -1;
}

/// Draw a tile and keep how long that took, where somebody asks.
void time_tile(const Frame& frame, int tile_index, TileScratch& scratch) {
    std::vector<double>& ms = frame.buffers.tile_ms;
    const auto place = static_cast<std::size_t>(tile_index);
    if (place >= ms.size()) return render_tile(frame, tile_index, scratch);
    Stopwatch watch;
    render_tile(frame, tile_index, scratch);
    ms[place] = watch.lap_ms();
}

}  // namespace

void render_tiles(const Frame& frame) {
    const std::vector<int>& chosen = frame.buffers.tiles;
    const raster::TileGrid& grid = frame.buffers.triangles.grid;
    const int tile_count = chosen.empty() ? grid.columns * grid.rows : static_cast<int>(chosen.size());
    const int first = tile_to_debug(frame);
    if (first >= 0) render_tile(frame, first, *frame.buffers.scratch[0]);
#pragma omp parallel for schedule(dynamic)
    for (int t = 0; t < tile_count; ++t) {
        const int tile = chosen.empty() ? t : chosen[static_cast<std::size_t>(t)];
        if (tile == first) continue;
        time_tile(frame, tile, *frame.buffers.scratch[static_cast<std::size_t>(thread_number())]);
    }
}

void fit_scratch(const RenderPlan& plan, TileScratch& scratch) {
    const bool points = std::any_of(plan.passes.begin(), plan.passes.end(), works_on_points);
    if (points && !scratch.fragments) scratch.fragments = std::make_unique<raster::Fragments>();
    if ((points || plan.environment_background) && !scratch.lighting) {
        scratch.lighting = std::make_unique<lighting::LightingChannels>();
    }
    if (plan.shading_rate > 1 && !scratch.points) scratch.points = std::make_unique<raster::ShadingPoints>();
    scratch.clock.clear(plan.passes.size());
    scratch.samples_shaded = 0;
    scratch.shown = {};
    scratch.color_is_background = false;
    scratch.views.resize(plan.views.size());
}

/// Draw the triangles of the tile into scratch.visibility and find the runs of what is seen.
void find_nearest(const PassWork& work) {
    const Frame& frame = work.frame;
    TileScratch& scratch = work.scratch;
    const bool depth_is_shown = !frame.plan.views.empty();
    if (!depth_is_shown && !any_triangle_touches(frame.buffers.triangles, work.area)) return;
    rasterize_tile(frame.buffers.streams, frame.buffers.triangles, work.area, scratch.visibility);
    scratch.run_count = collect_runs(scratch.visibility, work.area, frame.buffers.triangles, scratch.runs);
    scratch.samples_shaded += static_cast<std::uint64_t>(samples_of(scratch.runs, scratch.run_count));
}

/// What the film and the views show where nothing is seen.
void start_background(const PassWork& work) {
    const Frame& frame = work.frame;
    TileScratch& scratch = work.scratch;
    const int covered = samples_of(scratch.runs, scratch.run_count);
    if (frame.plan.film && covered < work.area.width * work.area.height) start_color(frame, work.area, scratch);
    scratch.color_is_background = covered == 0 && !frame.plan.environment_background;
    for (std::size_t v = 0; v < frame.plan.views.size(); ++v) {
        fill_background(glm::vec3(frame.plan.views[v]->background), scratch.views[v]);
    }
}

/// The depth buffer as a view.
void show_depth(const PassWork& work) {
    TileColor& values = work.scratch.views[static_cast<std::size_t>(work.pass.index)];
    std::copy_n(work.scratch.visibility.depth, kTileSide * kTileSide, values.plane[0]);
}

/// From here on the tile's runs are the points that are lit.
void choose_shading_points(const PassWork& work) {
    TileScratch& scratch = work.scratch;
    if (scratch.run_count == 0) return;
    const int seen = samples_of(scratch.runs, scratch.run_count);
    scratch.run_count = collect_shading_points(scratch.visibility, work.area, work.frame.buffers.triangles,
                                               work.frame.plan.shading_rate, scratch.runs, *scratch.points);
    scratch.points_are_chosen = true;
    scratch.samples_shaded -= static_cast<std::uint64_t>(seen - scratch.run_count);
}

/// The radiance of each point, and what views show there, to the samples in whose place it was lit.
void spread_points(const PassWork& work) {
    TileScratch& scratch = work.scratch;
    if (!scratch.points_are_chosen) return;
    const RenderPlan& plan = work.frame.plan;
    for (int c = 0; plan.film && c < 3; ++c) spread(*scratch.points, work.area, scratch.color.plane[c]);
    for (std::size_t v = 0; v < plan.views.size(); ++v) {
        const bool is_depth = !plan.views[v]->value;  // it is there for every sample
        for (int c = 0; !is_depth && c < plan.views[v]->components; ++c) {
            spread(*scratch.points, work.area, scratch.views[v].plane[c]);
        }
    }
}

void paint_flat(const PassWork& work) {
    TileScratch& scratch = work.scratch;
    paint_flat_runs(work.frame.buffers, scratch.runs, scratch.run_count, scratch.color);
    const glm::ivec2 wanted = sample_to_debug(work.area, work.frame.plan.samples);
    if (wanted.x < 0) return;
    if (cut_out_sample(scratch.runs, scratch.run_count, wanted) == scratch.run_count)
        return pixel_not_covered(debug_pixel.x, debug_pixel.y);
    pixel_reached(debug_pixel.x, debug_pixel.y);
}

/// The tile's pixels as a display is sent them. Nobody keeps their radiance.
void write_bytes(const PassWork& work) {
    const int n = work.frame.plan.samples, width = work.area.width / n;
    const raster::FilmSettings settings = film_settings(work.frame.scene.image);
    raster::ByteImage& picture = work.frame.buffers.bytes;
    float means[3][kTileSide];
    for (int y = 0; y < work.area.height / n; ++y) {
        const float* row[3];
        for (int c = 0; c < 3; ++c) row[c] = pixel_row(work.scratch.color.plane[c], y, width, n, means[c]);
        const std::size_t first = static_cast<std::size_t>(work.area.y / n + y) * picture.width + work.area.x / n;
        show_row(row, width, settings, picture.values.data() + 3 * first, work.scratch.shown);
    }
}

void write_film(const PassWork& work) {
    RenderBuffers& buffers = work.frame.buffers;
    const TileScratch& scratch = work.scratch;
    if (work.frame.plan.film) write_picture(work.area, work.frame.plan.samples, scratch.color, buffers.film);
    for (std::size_t v = 0; v < buffers.views.size(); ++v) {
        write_picture(work.area, work.frame.plan.samples, scratch.views[v], buffers.views[v]);
    }
    raster::finish_copies();
}

}  // namespace kreda::scene
