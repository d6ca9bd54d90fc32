#include "scene/plan/seen.hpp"

#include <algorithm>
#include <atomic>
#include <memory>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "raster/fragments.hpp"
#include "scene/instances.hpp"
#include "scene/plan/light_reach.hpp"
#include "scene/plan/lit_samples.hpp"
#include "scene/plan/placed.hpp"
#include "scene/plan/plan.hpp"
#include "scene/sides.hpp"

namespace kreda::scene {

namespace {

Placed place(const Scene& scene, const RenderPlan& plan) {
    Placed placed;
    placed.instances = make_instances(scene);
    const float aspect = raster::aspect_of(scene.image.width, scene.image.height);
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
    std::vector<int> tile_of_material;  ///< a tile that shows it; -1: none did
};

/// Count the samples of a tile by what they show, and mark their triangles.
void look_at_tile(const Placed& placed, const RenderPlan& plan, int tile, TileLook& look, Marks& marks) {
    const raster::TileArea area = tile_area(placed.triangles.grid, plan.viewport, tile);
    if (!any_triangle_touches(placed.triangles, area)) return;
    rasterize_tile(placed.streams, placed.triangles, area, look.visibility);
    const int run_count = collect_runs(look.visibility, area, placed.triangles, look.runs);
    for (int r = 0; r < run_count; ++r) {
        const raster::Run& run = look.runs[r];
        const std::uint32_t chunk = run.triangle >> raster::kChunkShift;
        const std::uint32_t triangle = run.triangle & ((1u << raster::kChunkShift) - 1);
        look.of_material[run.material] += run.count;
        look.tile_of_material[run.material] = tile;
        look.of_object[placed.triangles.chunks[chunk].instance] += run.count;
        std::atomic_ref<std::uint8_t>(marks[chunk][triangle]).store(1, std::memory_order_relaxed);
    }
}

/// What all threads saw together.
struct Look {
    Marks marks;
    std::vector<int> tile_of_material;
};

void add_samples(const TileLook& look, Look& all, Seen& seen) {
    for (std::size_t m = 0; m < look.of_material.size(); ++m) {
        all.tile_of_material[m] = std::max(all.tile_of_material[m], look.tile_of_material[m]);
        seen.of_material[m] += look.of_material[m];
        seen.covered += look.of_material[m];
    }
    for (std::size_t o = 0; o < look.of_object.size(); ++o) seen.objects[o].samples += look.of_object[o];
}

Look look_at_samples(const Placed& placed, const RenderPlan& plan, Seen& seen) {
    Look all{make_marks(placed.triangles), std::vector<int>(seen.of_material.size(), -1)};
    const raster::TileGrid& grid = placed.triangles.grid;
    const int tile_count = grid.columns * grid.rows;
#pragma omp parallel
    {
        const auto look = std::make_unique<TileLook>();
        look->of_material.assign(seen.of_material.size(), 0);
        look->of_object.assign(seen.objects.size(), 0);
        look->tile_of_material.assign(seen.of_material.size(), -1);
#pragma omp for schedule(dynamic)
        for (int t = 0; t < tile_count; ++t) look_at_tile(placed, plan, t, *look, all.marks);
#pragma omp critical
        add_samples(*look, all, seen);
    }
    return all;
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

/// A seen triangle where it is lit: whole, before any clipping. Its normals are those of the side that is seen.
LitTriangle lit_triangle(const Placed& placed, const RenderPlan& plan, const raster::TriangleChunk& chunk,
                         const raster::ScreenTriangle& triangle) {
    const raster::MeshInstance& instance = placed.instances[chunk.instance];
    const std::uint32_t* index = &instance.mesh->indices[3 * std::size_t{triangle.source - chunk.first_source}];
    const float side = plan.two_sided && triangle.behind ? -1.0f : 1.0f;
    LitTriangle lit;
    for (std::size_t k = 0; k < 3; ++k) {
        lit.position[k] = placed.streams.position_world[instance.first_vertex + index[k]];
        lit.normal[k] = side * placed.streams.normal_world[instance.first_vertex + index[k]];
    }
    lit.any_normal = reads_normal_map(plan.materials[triangle.material].material);
    return lit;
}

/// The one point at which a triangle is lit that has one colour.
glm::vec3 face_normal(const LitTriangle& triangle, const raster::MeshInstance& instance) {
    const auto& [a, b, c] = triangle.position;
    const glm::vec3 normal = glm::cross(b - a, c - a);
    return raster::is_mirrored(glm::mat3(instance.world_from_object)) ? -normal : normal;
}

/// Does the light reach one of the points of a seen triangle at which it is lit? At samples: may it?
bool reaches(const lighting::LightSetup& light, const Placed& placed, const RenderPlan& plan,
             const raster::TriangleChunk& chunk, const raster::ScreenTriangle& triangle) {
    const LitTriangle lit = lit_triangle(placed, plan, chunk, triangle);
    const auto& [a, b, c] = lit.position;
    switch (plan.frequency) {
        case ShadingFrequency::phong: return may_reach(light, lit);
        case ShadingFrequency::gouraud:
            return reaches_point(light, a, lit.normal[0], lit.any_normal) ||
                   reaches_point(light, b, lit.normal[1], lit.any_normal) ||
                   reaches_point(light, c, lit.normal[2], lit.any_normal);
        case ShadingFrequency::flat: {
            const glm::vec3 n = face_normal(lit, placed.instances[chunk.instance]);
            const bool turned = plan.two_sided && triangle.behind;
            return reaches_point(light, (a + b + c) * (1.0f / 3.0f), turned ? -n : n, lit.any_normal);
        }
    }
    return true;
}

Viewer viewer_of(const Scene& scene) {
    return {scene.camera.position, view_direction(scene.camera),
            scene.camera.projection == raster::Projection::orthographic};
}

/// Call visit(chunk, triangle) for the triangles that some sample shows.
template <class Visit>
void for_each_marked(Placed& placed, const Marks& marks, Visit visit) {
    for (std::size_t c = 0; c < marks.size(); ++c) {
        raster::TriangleChunk& chunk = placed.triangles.chunks[c];
        for (std::size_t t = 0; t < marks[c].size(); ++t) {
            if (marks[c][t]) visit(chunk, chunk.triangles[t]);
        }
    }
}

/// Which side of the seen triangles is seen, as the pass "sides" finds it.
void turn_sides(const Scene& scene, const RenderPlan& plan, const Marks& marks, Placed& placed, Seen& seen) {
    if (!plan.two_sided || plan.frequency == ShadingFrequency::flat) return;
    const Viewer viewer = viewer_of(scene);
    for_each_marked(placed, marks, [&](const raster::TriangleChunk&, raster::ScreenTriangle& triangle) {
        const bool behind = judge_side(placed.streams, viewer, triangle);
        seen.any_turned |= behind != (triangle.behind != 0);
        triangle.behind = behind;
    });
}

/// Ask the seen triangles what lights reach them. Soon every light has reached every material, and there is nothing
/// left to ask.
void look_at_triangles(const Scene& scene, const RenderPlan& plan, const Marks& marks, Placed& placed, Seen& seen) {
    std::vector<lighting::LightSetup> lights;
    for (const lighting::Light& light : scene.lights) lights.push_back(prepare(light));
    for_each_marked(placed, marks, [&](const raster::TriangleChunk& chunk, const raster::ScreenTriangle& triangle) {
        for (std::size_t k = 0; k < lights.size(); ++k) {
            if (seen.reached[k][triangle.material] || !scene.lights[k].on) continue;
            seen.reached[k][triangle.material] = reaches(lights[k], placed, plan, chunk, triangle);
        }
        for (const std::uint32_t v : triangle.vertex) {
            seen.farthest =
                std::max(seen.farthest, glm::length(placed.streams.position_world[v] - scene.camera.position));
        }
    });
}

}  // namespace

Seen look_at(const Scene& scene, const RenderPlan& plan) {
    Seen seen;
    seen.of_material.assign(scene.materials.size(), 0);
    seen.objects.resize(scene.objects.size());
    seen.reached.assign(scene.lights.size(), std::vector<bool>(scene.materials.size(), false));
    if (scene.objects.empty()) return seen;
    Placed placed = place(scene, plan);
    const Look look = look_at_samples(placed, plan, seen);
    add_counts(placed.triangles, seen);
    turn_sides(scene, plan, look.marks, placed, seen);
    look_at_triangles(scene, plan, look.marks, placed, seen);
    if (plan.frequency == ShadingFrequency::phong) {
        keep_what_reaches_samples(scene, plan, placed, look.tile_of_material, seen);
    }
    return seen;
}

}  // namespace kreda::scene
