#include "scene/render/tile_pass.hpp"

#include <algorithm>

#include "raster/copy_past_cache.hpp"
#include "raster/platform.hpp"
#include "scene/render/background.hpp"
#include "scene/render/debug_pixel.hpp"
#include "scene/render/shade.hpp"

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

/// The colour of a flat triangle, lit once.
glm::vec3 flat_color_of(const RenderBuffers& buffers, std::uint32_t id) {
    return buffers.flat_color[id >> raster::kChunkShift][id & ((1u << raster::kChunkShift) - 1)];
}

/// Flat shading in fog: every sample of a run starts with its triangle's colour.
KREDA_BATCH_LOOP void fill_flat_color(const RenderBuffers& buffers, const Run* runs, int count,
                                      raster::Fragments& fragments) {
    int first = 0;
    for (int r = 0; r < count; ++r) {
        const glm::vec3 color = flat_color_of(buffers, runs[r].triangle);
        for (int i = first; i < first + runs[r].count; ++i) fragments.color.set(i, color);
        first += runs[r].count;
    }
    fragments.count = first;
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

/// Which samples of the picture the points are: what was found for all of them beforehand is looked up by number.
void number_samples(const RenderPlan& plan, const TileArea& area, const Run* runs, int count,
                    raster::Fragments& fragments) {
    int point = 0;
    for (int r = 0; r < count; ++r) {
        const int first = (area.y + runs[r].y) * plan.viewport.width + area.x + runs[r].x;
        for (int i = 0; i < runs[r].count; ++i) fragments.sample[point++] = static_cast<std::uint32_t>(first + i);
    }
}

/// The radiance of every point of the batch, fog included.
void shade_batch(const Frame& frame, std::uint32_t material, TileScratch& scratch) {
    if (frame.plan.frequency == ShadingFrequency::phong) {
        shade_points(frame, scratch.fragments, material, scratch.lighting);
    } else {
        copy_color(scratch.fragments, scratch.lighting);
    }
    if (frame.plan.fog_at_pixels) fog_factors(scratch.fragments, frame.lighting, scratch.lighting);
    if (frame.plan.fog_at_vertices) copy_fog(scratch.fragments, scratch.lighting);
    if (frame.plan.fog_at_pixels || frame.plan.fog_at_vertices) {
        apply_fog(scratch.fragments.count, frame.lighting.fog.color, scratch.lighting);
    }
}

/// Runs are short: a plain loop beats a call of memcpy (scene/CMake flag -fno-tree-loop-distribute-patterns keeps it
/// one).
inline void copy_run(const float* __restrict from, int count, float* __restrict to) {
    for (int i = 0; i < count; ++i) to[i] = from[i];
}

/// Runs from r on that follow each other without a gap within their row, as one: how many samples. r moves behind them.
inline int samples_without_gap(const Run* runs, int count, int& r) {
    int samples = runs[r].count;
    const int x = runs[r].x, y = runs[r].y;
    for (++r; r < count && runs[r].y == y && runs[r].x == x + samples; ++r) samples += runs[r].count;
    return samples;
}

/// Put the batch's radiance where its runs lie in the tile.
KREDA_BATCH_LOOP void scatter_runs(const raster::Channel3& radiance, const Run* runs, int count, TileColor& color) {
    int first = 0;
    for (int r = 0; r < count;) {
        const int to = runs[r].y * kTileSide + runs[r].x;
        const int samples = samples_without_gap(runs, count, r);
        copy_run(radiance.x + first, samples, color.plane[0] + to);
        copy_run(radiance.y + first, samples, color.plane[1] + to);
        copy_run(radiance.z + first, samples, color.plane[2] + to);
        first += samples;
    }
}

void fill_background(const glm::vec3& background, TileColor& color) {
    for (int c = 0; c < 3; ++c) std::fill(std::begin(color.plane[c]), std::end(color.plane[c]), background[c]);
}

/// What is seen where nothing is drawn.
void start_color(const Frame& frame, const TileArea& area, TileScratch& scratch) {
    if (!frame.scene.image.environment_background) {
        if (!scratch.color_is_background) fill_background(frame.scene.image.background, scratch.color);
        return;
    }
    const ViewRays rays = view_rays(frame.scene.camera, frame.plan.viewport);
    float* const planes[3] = {scratch.color.plane[0], scratch.color.plane[1], scratch.color.plane[2]};
    look_past_tile(rays, frame.lighting.environment, area, scratch.lighting.environment, planes);
}

/// The values of a view at the points of the batch, into the tile.
void write_view(const View& view, const BatchChannels& batch, const Run* runs, int count, TileColor& values) {
    for (int c = 0; c < view.components; ++c) {
        int point = 0;
        for (int r = 0; r < count; ++r) {
            float* to = values.plane[c] + runs[r].y * kTileSide + runs[r].x;
            for (int i = 0; i < runs[r].count; ++i) to[i] = view.value(batch, point++, c);
        }
    }
}

void write_views(const Frame& frame, const Run* runs, int count, TileScratch& scratch) {
    const BatchChannels batch{scratch.fragments, scratch.lighting};
    for (std::size_t v = 0; v < frame.plan.views.size(); ++v) {
        const View& view = *frame.plan.views[v];
        if (view.value && view.holds(frame.plan, runs[0].material))
            write_view(view, batch, runs, count, scratch.views[v]);
    }
}

/// Before the batches: the depth buffer, and what a view shows where nothing is seen.
void start_views(const RenderPlan& plan, TileScratch& scratch) {
    scratch.views.resize(plan.views.size());
    for (std::size_t v = 0; v < plan.views.size(); ++v) {
        TileColor& values = scratch.views[v];
        fill_background(glm::vec3(plan.views[v]->background), values);
        if (!plan.views[v]->value) std::copy_n(scratch.visibility.depth, kTileSide * kTileSide, values.plane[0]);
    }
}

/// One pixel is the mean of its n x n samples, added row by row, left to right.
float mean_of_samples(const float* plane, int x, int y, int n) {
    float sum = 0.0f;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) sum += plane[(y * n + j) * kTileSide + x * n + i];
    }
    return sum / static_cast<float>(n * n);
}

/// Tile -> film: copy, or average the samples of each pixel.
void write_film(const TileArea& area, int n, const TileColor& color, raster::Image& film) {
    const int x0 = area.x / n;
    const int y0 = area.y / n;
    for (int c = 0; c < film.channels; ++c) {
        for (int y = 0; y < area.height / n; ++y) {
            float* row = film.plane(c) + static_cast<std::size_t>(y0 + y) * film.width + x0;
            if (n == 1) {
                raster::copy_past_cache(color.plane[c] + y * kTileSide, area.width, row);
                continue;
            }
            for (int x = 0; x < area.width / n; ++x) row[x] = mean_of_samples(color.plane[c], x, y, n);
        }
    }
}

int samples_of(const Run* runs, int count) {
    int samples = 0;
    for (int r = 0; r < count; ++r) samples += runs[r].count;
    return samples;
}

/// Flat shading in clear air has nothing left to compute at a pixel.
bool only_painting_left(const RenderPlan& plan) {
    return plan.frequency == ShadingFrequency::flat && !plan.fragment.any() && plan.views.empty();
}

/// Shade runs that are grouped by material, batch by batch.
void shade_batches(const Frame& frame, const TileArea& area, const Run* runs, int run_count, TileScratch& scratch) {
    if (only_painting_left(frame.plan)) return paint_flat_runs(frame.buffers, runs, run_count, scratch.color);
    for (int done = 0; done < run_count;) {
        const int count = runs_of_one_batch(runs + done, run_count - done);
        work_batch(frame, area, runs + done, count, scratch);
        done += count;
    }
}

/// Shade all runs of the tile; the sample that a debugger wants to see in a batch of its own.
void shade_runs(const Frame& frame, const TileArea& area, int run_count, TileScratch& scratch) {
    Run* runs = scratch.runs;
    if (!only_painting_left(frame.plan)) group_by_material(runs, run_count);
    const glm::ivec2 wanted = sample_to_debug(area, frame.plan.samples);
    if (wanted.x < 0) return shade_batches(frame, area, runs, run_count, scratch);

    const int debugged = cut_out_sample(runs, run_count, wanted);
    shade_batches(frame, area, runs, debugged, scratch);
    if (debugged == run_count) return pixel_not_covered(debug_pixel.x, debug_pixel.y);
    pixel_reached(debug_pixel.x, debug_pixel.y);
    shade_batches(frame, area, runs + debugged, 1, scratch);
    shade_batches(frame, area, runs + debugged + 1, run_count - debugged - 1, scratch);
}

/// Draw the triangles of the tile into scratch.visibility and find the runs of what is seen. Returns their number.
int find_visible(const Frame& frame, const TileArea& area, TileScratch& scratch) {
    const bool depth_is_shown = !frame.plan.views.empty();
    if (!depth_is_shown && !any_triangle_touches(frame.buffers.triangles, area)) return 0;
    rasterize_tile(frame.buffers.streams, frame.buffers.triangles, area, scratch.visibility);
    return find_runs(scratch.visibility, area, frame.buffers.triangles, scratch.runs);
}

}  // namespace

void work_batch(const Frame& frame, const TileArea& area, const Run* runs, int count, TileScratch& scratch) {
    scratch.fragments.count = 0;
    const raster::FragmentNeeds& needs = frame.plan.fragment_of_material[runs[0].material];
    if (needs.any()) {
        interpolate_runs(frame.buffers.streams, frame.buffers.triangles, area, runs, count, needs,
                         frame.plan.interpolation, scratch.fragments);
    }
    if (frame.plan.frequency == ShadingFrequency::flat) {
        fill_flat_color(frame.buffers, runs, count, scratch.fragments);
    }
    scratch.interpolation_ms += scratch.watch.lap_ms();
    if (frame.plan.shadows_by_frame) number_samples(frame.plan, area, runs, count, scratch.fragments);
    shade_batch(frame, runs[0].material, scratch);
    scatter_runs(scratch.lighting.radiance, runs, count, scratch.color);
    write_views(frame, runs, count, scratch);
    scratch.lighting_ms += scratch.watch.lap_ms();
}

void render_tile(const Frame& frame, int tile_index, TileScratch& scratch) {
    scratch.watch.lap_ms();
    const TileArea area = tile_area(frame.buffers.triangles.grid, frame.plan.viewport, tile_index);
    const int run_count = find_visible(frame, area, scratch);
    const int covered = samples_of(scratch.runs, run_count);
    if (covered < area.width * area.height) start_color(frame, area, scratch);
    scratch.color_is_background = covered == 0 && !frame.scene.image.environment_background;
    start_views(frame.plan, scratch);
    scratch.visibility_ms += scratch.watch.lap_ms();
    shade_runs(frame, area, run_count, scratch);
    scratch.samples_shaded += static_cast<std::uint64_t>(covered);
    write_film(area, frame.plan.samples, scratch.color, frame.buffers.film);
    for (std::size_t v = 0; v < scratch.views.size(); ++v) {
        write_film(area, frame.plan.samples, scratch.views[v], frame.buffers.views[v]);
    }
    raster::finish_copies();
    scratch.film_ms += scratch.watch.lap_ms();
}

}  // namespace kreda::scene
