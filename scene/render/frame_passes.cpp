// Passes over the whole scene: its vertices and its triangles.
#include "scene/plan/pass_functions.hpp"
#include "scene/render/pass_work.hpp"
#include "scene/render/render.hpp"
#include "scene/sides.hpp"

namespace kreda::scene {

namespace {

/// One colour a triangle, for flat shading.
void make_room_for_colors(RenderBuffers& buffers) {
    const std::vector<raster::TriangleChunk>& chunks = buffers.triangles.chunks;
    buffers.flat_color.resize(chunks.size());
    for (std::size_t c = 0; c < chunks.size(); ++c) buffers.flat_color[c].resize(chunks[c].triangles.size());
}

}  // namespace

void place_vertices(const PassWork& work) {
    RenderBuffers& buffers = work.frame.buffers;
    transform_vertices(buffers.instances, work.frame.clip_from_world, work.frame.plan.viewport, buffers.streams);
}

void place_triangles(const PassWork& work) {
    const RenderPlan& plan = work.frame.plan;
    RenderBuffers& buffers = work.frame.buffers;
    work.frame.statistics.triangles = setup_triangles(buffers.instances, work.frame.clip_from_world, plan.viewport,
                                                      plan.cull, plan.samples, buffers.streams, buffers.triangles);
    if (plan.frequency == ShadingFrequency::flat) make_room_for_colors(buffers);
}

/// Of every triangle that reached the tiles: the answer is ScreenTriangle::behind.
void judge_sides(const PassWork& work) {
    const lighting::LightingSetup& lighting = work.frame.lighting;
    const Viewer viewer{lighting.eye, lighting.forward, lighting.orthographic};
    std::vector<raster::TriangleChunk>& chunks = work.frame.buffers.triangles.chunks;
    const int chunk_count = static_cast<int>(chunks.size());
#pragma omp parallel for schedule(dynamic) if (chunk_count > 1)
    for (int i = 0; i < chunk_count; ++i) {
        for (raster::ScreenTriangle& triangle : chunks[static_cast<std::size_t>(i)].triangles) {
            triangle.behind = judge_side(work.frame.buffers.streams, viewer, triangle);
        }
    }
}

}  // namespace kreda::scene
