// Passes over a batch of a tile: interpolate, light, fog, back into the tile. What they wrote on the way stays in
// scratch.fragments and scratch.lighting.
#include "lighting/batch/fog_passes.hpp"
#include "raster/platform.hpp"
#include "scene/plan/pass_functions.hpp"
#include "scene/render/pass_work.hpp"
#include "scene/render/shade.hpp"
#include "scene/render/tile_pass.hpp"

namespace kreda::scene {

namespace {

using raster::kTileSide;
using raster::Run;
using raster::TileArea;

/// Which samples of the picture the points are: what was found for all of them beforehand is looked up by number.
void number_samples(const RenderPlan& plan, const TileArea& area, const Run* runs, int count,
                    raster::Fragments& fragments) {
    int point = 0;
    for (int r = 0; r < count; ++r) {
        const int first = (area.y + runs[r].y) * plan.viewport.width + area.x + runs[r].x;
        for (int i = 0; i < runs[r].count; ++i) {
            fragments.sample[point++] = static_cast<std::uint32_t>(first + i * runs[r].step);
        }
    }
}

/// Every sample of a run starts with its triangle's colour.
KREDA_BATCH_LOOP void fill_flat_color(const RenderBuffers& buffers, const Run* runs, int count,
                                      raster::Fragments& fragments) {
    int first = 0;
    for (int r = 0; r < count; ++r) {
        const glm::vec3 color = flat_color_of(buffers, runs[r].triangle);
        for (int i = first; i < first + runs[r].count; ++i) fragments.color.set(i, color);
        first += runs[r].count;
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

/// The same where not every sample is lit: one point after the other.
void scatter_points(const raster::Channel3& radiance, const Run* runs, int count, TileColor& color) {
    int point = 0;
    for (int r = 0; r < count; ++r) {
        int to = runs[r].y * kTileSide + runs[r].x;
        for (int i = 0; i < runs[r].count; ++i, ++point, to += runs[r].step) {
            color.plane[0][to] = radiance.x[point];
            color.plane[1][to] = radiance.y[point];
            color.plane[2][to] = radiance.z[point];
        }
    }
}

/// The values of a view at the points of the batch, into the tile.
void write_view(const View& view, const BatchChannels& batch, const Run* runs, int count, TileColor& values) {
    for (int c = 0; c < view.components; ++c) {
        int point = 0;
        for (int r = 0; r < count; ++r) {
            float* to = values.plane[c] + runs[r].y * kTileSide + runs[r].x;
            for (int i = 0; i < runs[r].count; ++i) to[i * runs[r].step] = view.value(batch, point++, c);
        }
    }
}

}  // namespace

/// Attributes of the visible samples; where they were lit or fogged at the vertices, radiance and fog are among them.
void interpolate(const PassWork& work) {
    const RenderPlan& plan = work.frame.plan;
    const RenderBuffers& buffers = work.frame.buffers;
    TileScratch& scratch = work.scratch;
    const raster::FragmentNeeds& needs = plan.fragment_of_material[work.material];
    if (needs.any()) {
        interpolate_runs(buffers.streams, buffers.triangles, work.area, work.runs, work.run_count, needs,
                         plan.interpolation, *scratch.fragments, plan.shading_rate);
    }
    if (plan.shadows_by_frame) number_samples(plan, work.area, work.runs, work.run_count, *scratch.fragments);
    if (needs.color) lighting::copy_color(*scratch.fragments, *scratch.lighting);
    if (needs.fog) lighting::copy_fog(*scratch.fragments, *scratch.lighting);
}

void light_samples(const PassWork& work) {
    shade_points(work.frame, *work.scratch.fragments, work.material, *work.scratch.lighting, work.scratch);
}

void color_flat(const PassWork& work) {
    fill_flat_color(work.frame.buffers, work.runs, work.run_count, *work.scratch.fragments);
    lighting::copy_color(*work.scratch.fragments, *work.scratch.lighting);
}

void fog_samples(const PassWork& work) {
    lighting::fog_factors(*work.scratch.fragments, work.frame.lighting, *work.scratch.lighting);
}

void mix_fog(const PassWork& work) {
    lighting::apply_fog(work.scratch.fragments->count, work.frame.lighting.fog.color, *work.scratch.lighting);
}

void paint(const PassWork& work) {
    const bool all = work.frame.plan.shading_rate == 1;
    (all ? scatter_runs : scatter_points)(work.scratch.lighting->radiance, work.runs, work.run_count,
                                          work.scratch.color);
}

void show_view(const PassWork& work) {
    const auto number = static_cast<std::size_t>(work.pass.index);
    const View& view = *work.frame.plan.views[number];
    if (!view.holds(work.frame.plan, work.material)) return;
    write_view(view, {*work.scratch.fragments, *work.scratch.lighting}, work.runs, work.run_count,
               work.scratch.views[number]);
}

}  // namespace kreda::scene
