#include "scene/plan/seen.hpp"

#include <algorithm>
#include <atomic>
#include <memory>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "raster/fragments.hpp"
#include "scene/instances.hpp"
#include "scene/plan/light_reach.hpp"
#include "scene/plan/plan.hpp"
#include "scene/sides.hpp"

namespace kreda::scene {

namespace {

/// The scene on the sample grid, as the passes "vertices" and "triangles" leave it.
struct Placed {
    std::vector<raster::MeshInstance> instances;
    raster::VertexStreams streams;
    raster::TriangleSet triangles;
};

Placed place(const Scene& scene, const RenderPlan& plan) {
    Placed placed;
    placed.instances = make_instances(scene);
    const float aspect = static_cast<float>(scene.image.width) / static_cast<float>(scene.image.height);
    const glm::mat4 clip_from_world = raster::clip_from_world(scene.camera, aspect);
    lay_out_vertices(placed.instances, {.position_world = true, .normal_world = true}, placed.streams);
    transform_vertices(placed.instances, clip_from_world, plan.viewport, placed.streams);
    setup_triangles(placed.instances, clip_from_world, plan.viewport, plan.cull, plan.samples, placed.streams,
                    placed.triangles);
    return placed;
}

/// One mark a triangle, chunk by chunk: some sample shows it.
using Marks = std::vector<std::vector<std::uint8_t>>;

Marks make_marks(const raster::TriangleSet& set) {
    Marks marks;
    for (const raster::TriangleChunk& chunk : set.chunks) marks.emplace_back(chunk.triangles.size(), std::uint8_t{0});
    return marks;
}

struct TileLook {
    raster::TileVisibility visibility;
    raster::Run runs[raster::kTileSide * raster::kTileSide];
    std::vector<std::uint64_t> of_material, of_object;
};

/// Count the samples of a tile by what they show, and mark their triangles.
void look_at_tile(const Placed& placed, const raster::TileArea& area, TileLook& look, Marks& marks) {
    if (!any_triangle_touches(placed.triangles, area)) return;
    rasterize_tile(placed.streams, placed.triangles, area, look.visibility);
    const int run_count = find_runs(look.visibility, area, placed.triangles, look.runs);
    for (int r = 0; r < run_count; ++r) {
        const raster::Run& run = look.runs[r];
        const std::uint32_t chunk = run.triangle >> raster::kChunkShift;
        const std::uint32_t triangle = run.triangle & ((1u << raster::kChunkShift) - 1);
        look.of_material[run.material] += run.count;
        look.of_object[placed.triangles.chunks[chunk].instance] += run.count;
        std::atomic_ref<std::uint8_t>(marks[chunk][triangle]).store(1, std::memory_order_relaxed);
    }
}

void add_samples(const TileLook& look, Seen& seen) {
    for (std::size_t m = 0; m < look.of_material.size(); ++m) {
        seen.of_material[m] += look.of_material[m];
        seen.covered += look.of_material[m];
    }
    for (std::size_t o = 0; o < look.of_object.size(); ++o) seen.objects[o].samples += look.of_object[o];
}

Marks look_at_samples(const Placed& placed, const RenderPlan& plan, Seen& seen) {
    Marks marks = make_marks(placed.triangles);
    const raster::TileGrid& grid = placed.triangles.grid;
    const int tile_count = grid.columns * grid.rows;
#pragma omp parallel
    {
        const auto look = std::make_unique<TileLook>();
        look->of_material.assign(seen.of_material.size(), 0);
        look->of_object.assign(seen.objects.size(), 0);
#pragma omp for schedule(dynamic)
        for (int t = 0; t < tile_count; ++t) look_at_tile(placed, tile_area(grid, plan.viewport, t), *look, marks);
#pragma omp critical
        add_samples(*look, seen);
    }
    return marks;
}

void add_counts(const raster::TriangleSet& set, Seen& seen) {
    for (const raster::TriangleChunk& chunk : set.chunks) {
        raster::TriangleCounts& sum = seen.objects[chunk.instance].triangles;
        sum.input += chunk.counts.input;
        sum.drawn += chunk.counts.drawn;
        sum.culled += chunk.counts.culled;
        sum.outside += chunk.counts.outside;
        sum.degenerate += chunk.counts.degenerate;
        sum.non_finite += chunk.counts.non_finite;
        sum.clipped += chunk.counts.clipped;
    }
}

/// A seen triangle where it is lit: whole, before any clipping.
LitTriangle lit_triangle(const Placed& placed, const RenderPlan& plan, const raster::TriangleChunk& chunk,
                         const raster::ScreenTriangle& triangle) {
    const raster::MeshInstance& instance = placed.instances[chunk.instance];
    const std::uint32_t* index = &instance.mesh->indices[3 * std::size_t{triangle.source - chunk.first_source}];
    LitTriangle lit;
    for (std::size_t k = 0; k < 3; ++k) {
        lit.position[k] = placed.streams.position_world[instance.first_vertex + index[k]];
        lit.normal[k] = placed.streams.normal_world[instance.first_vertex + index[k]];
    }
    if (plan.frequency == ShadingFrequency::flat) {
        const bool mirrored = glm::determinant(glm::dmat3(instance.world_from_object)) < 0.0;
        const glm::vec3 across = glm::cross(lit.position[1] - lit.position[0], lit.position[2] - lit.position[0]) *
                                 (mirrored ? -1.0f : 1.0f);
        lit.normal = {across, across, across};
    }
    lit.any_normal = plan.two_sided || reads_normal_map(plan.materials[triangle.material].material);
    return lit;
}

Viewer viewer_of(const Scene& scene) {
    return {scene.camera.position, view_direction(scene.camera),
            scene.camera.projection == raster::Projection::orthographic};
}

/// Ask the seen triangles what lights reach them. Soon every light has reached every material, and there is nothing
/// left to ask.
void look_at_triangles(const Scene& scene, const RenderPlan& plan, const Placed& placed, const Marks& marks,
                       Seen& seen) {
    std::vector<lighting::LightSetup> lights;
    for (const lighting::Light& light : scene.lights) lights.push_back(prepare(light));
    seen.reached.assign(lights.size(), std::vector<bool>(scene.materials.size(), false));
    const Viewer viewer = viewer_of(scene);
    const bool sides = plan.two_sided && plan.frequency != ShadingFrequency::flat;
    for (std::size_t c = 0; c < marks.size(); ++c) {
        const raster::TriangleChunk& chunk = placed.triangles.chunks[c];
        for (std::size_t t = 0; t < marks[c].size(); ++t) {
            if (!marks[c][t]) continue;
            const raster::ScreenTriangle& triangle = chunk.triangles[t];
            const LitTriangle lit = lit_triangle(placed, plan, chunk, triangle);
            for (std::size_t k = 0; k < lights.size(); ++k) {
                if (seen.reached[k][triangle.material] || !scene.lights[k].on) continue;
                seen.reached[k][triangle.material] = may_reach(lights[k], lit);
            }
            for (const glm::vec3& p : lit.position)
                seen.farthest = std::max(seen.farthest, glm::length(p - viewer.eye));
            if (!sides || seen.any_turned) continue;
            seen.any_turned = find_side(placed.streams, viewer, triangle) != (triangle.behind != 0);
        }
    }
}

}  // namespace

Seen look_at(const Scene& scene, const RenderPlan& plan) {
    Seen seen;
    seen.of_material.assign(scene.materials.size(), 0);
    seen.objects.resize(scene.objects.size());
    seen.reached.assign(scene.lights.size(), std::vector<bool>(scene.materials.size(), false));
    if (scene.objects.empty()) return seen;
    const Placed placed = place(scene, plan);
    const Marks marks = look_at_samples(placed, plan, seen);
    add_counts(placed.triangles, seen);
    look_at_triangles(scene, plan, placed, marks, seen);
    return seen;
}

}  // namespace kreda::scene
