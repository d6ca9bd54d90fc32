#include "scene/render/early_lighting.hpp"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

#include "lighting/batch/fog_passes.hpp"
#include "scene/plan/pass_functions.hpp"
#include "scene/render/pass_work.hpp"
#include "scene/render/render.hpp"
#include "scene/render/shade.hpp"
#include "scene/render/threads.hpp"

namespace kreda::scene {

namespace {

using raster::kBatchCapacity;

/// Call work(begin, count, scratch) for 0 .. total in steps of a batch, in parallel. `pass` is told how long it took.
template <class Work>
void for_each_batch(const PassWork& pass, int total, Work work) {
    constexpr int kWorthThreads = 8 * kBatchCapacity;
    const std::size_t number = number_of(pass.frame, pass.pass);
#pragma omp parallel if (total > kWorthThreads)
    {
        TileScratch& scratch = *pass.frame.buffers.scratch[static_cast<std::size_t>(thread_number())];
        scratch.clock.start();
#pragma omp for schedule(dynamic)
        for (int begin = 0; begin < total; begin += kBatchCapacity) {
            const int count = std::min(kBatchCapacity, total - begin);
            scratch.fragments->count = count;
            work(begin, count, scratch);
            scratch.clock.lap(number);
        }
    }
}

/// The vertices that a part uses: an unbroken range, because no vertex belongs to two parts. All of them where there is
/// one part: looking through its indices would take as long as lighting its vertices.
struct VertexRange {
    std::uint32_t first = 0, end = 0;
};
VertexRange vertices_of_part(const raster::Mesh& mesh, const raster::MeshPart& part) {
    if (mesh.parts.size() == 1) return {0, static_cast<std::uint32_t>(mesh.positions.size())};
    const auto begin = mesh.indices.begin() + 3 * static_cast<std::ptrdiff_t>(part.first_triangle);
    const auto end = begin + 3 * static_cast<std::ptrdiff_t>(part.triangle_count);
    if (begin == end) return {};
    const auto [least, greatest] = std::minmax_element(begin, end);
    return {*least, *greatest + 1};
}

/// Light the vertices of a range on one side of the surface.
void light_range(const PassWork& work, std::uint32_t material, std::uint32_t first, int total, bool behind,
                 raster::AlignedVector<glm::vec3>& color) {
    for_each_batch(work, total, [&](int begin, int count, TileScratch& scratch) {
        const std::uint32_t from = first + static_cast<std::uint32_t>(begin);
        set_vertex_points(work.frame, from, count, behind, *scratch.fragments);
        shade_points(work.frame, *scratch.fragments, material, *scratch.lighting, scratch);
        for (int i = 0; i < count; ++i) color[from + i] = scratch.lighting->radiance.at(i);
    });
}

/// How many of a chunk's triangles from `begin` on have its material, at most a batch.
int same_material(const raster::AlignedVector<raster::ScreenTriangle>& triangles, int begin) {
    const auto first = triangles.begin() + begin;
    const auto end = first + std::min<std::ptrdiff_t>(kBatchCapacity, triangles.end() - first);
    const auto is_other = [&](const raster::ScreenTriangle& triangle) { return triangle.material != first->material; };
    return static_cast<int>(std::find_if(first, end, is_other) - first);
}

/// Flat colours of one chunk of triangles; only of materials that are seen.
void light_chunk(const Frame& frame, const raster::TriangleChunk& chunk, std::vector<glm::vec3>& color,
                 TileScratch& scratch) {
    const int total = static_cast<int>(chunk.triangles.size());
    const float orientation = orientation_of(frame.buffers.instances[chunk.instance].world_from_object);
    for (int begin = 0, count = 0; begin < total; begin += count) {
        count = same_material(chunk.triangles, begin);
        const std::uint32_t material = chunk.triangles[static_cast<std::size_t>(begin)].material;
        if (!frame.plan.lighting.seen[material]) continue;
        for (int i = 0; i < count; ++i) {
            const raster::ScreenTriangle& triangle = chunk.triangles[begin + i];
            const bool behind = frame.plan.two_sided && triangle.behind;
            set_flat_point(frame.buffers, chunk, triangle, orientation, behind, i, *scratch.fragments);
        }
        scratch.fragments->count = count;
        shade_points(frame, *scratch.fragments, material, *scratch.lighting, scratch);
        for (int i = 0; i < count; ++i) color[begin + i] = scratch.lighting->radiance.at(i);
    }
}

/// A stream of vectors -> x, y and z apart.
void copy_points(const glm::vec3* __restrict from, int count, raster::Channel3& to) {
    for (int i = 0; i < count; ++i) to.set(i, from[i]);
}

void set_uv(const glm::vec2& uv, const glm::vec2& step_x, const glm::vec2& step_y, int i, raster::Fragments& points) {
    points.u.set(i, uv.x);
    points.v.set(i, uv.y);
    points.du_dx.set(i, step_x.x);
    points.dv_dx.set(i, step_x.y);
    points.du_dy.set(i, step_y.x);
    points.dv_dy.set(i, step_y.y);
}

void set_tangent(const glm::vec4& tangent, int i, raster::Fragments& points) {
    points.tangent.set(i, glm::vec3(tangent));
    points.tangent_side.set(i, tangent.w);
}

/// Point i on the other side of its surface.
void turn_point(int i, raster::Fragments& points) {
    points.normal.set(i, -points.normal.at(i));
    points.face_normal.set(i, -points.face_normal.at(i));
    points.tangent.set(i, -points.tangent.at(i));
    points.tangent_side.set(i, -points.tangent_side.at(i));
}

}  // namespace

void set_vertex_points(const Frame& frame, std::uint32_t first, int count, bool behind, raster::Fragments& points) {
    const raster::VertexStreams& streams = frame.buffers.streams;
    if (!streams.position_world.empty()) copy_points(&streams.position_world[first], count, points.position);
    if (!streams.normal_world.empty()) copy_points(&streams.normal_world[first], count, points.normal);
    if (!frame.plan.shadows.empty()) copy_points(&streams.normal_world[first], count, points.face_normal);
    for (int i = 0; i < count && !streams.uv.empty(); ++i) {
        set_uv(streams.uv[first + static_cast<std::uint32_t>(i)], glm::vec2(0.0f), glm::vec2(0.0f), i, points);
    }
    for (int i = 0; i < count && !streams.tangent_world.empty(); ++i) {
        set_tangent(streams.tangent_world[first + static_cast<std::uint32_t>(i)], i, points);
    }
    for (int i = 0; i < count && behind; ++i) turn_point(i, points);
}

float orientation_of(const glm::mat4& world_from_object) {
    return raster::is_mirrored(glm::mat3(world_from_object)) ? -1.0f : 1.0f;
}

void set_flat_point(const RenderBuffers& buffers, const raster::TriangleChunk& chunk,
                    const raster::ScreenTriangle& triangle, float orientation, bool behind, int i,
                    raster::Fragments& points) {
    const raster::MeshInstance& instance = buffers.instances[chunk.instance];
    const std::uint32_t* index = &instance.mesh->indices[3 * std::size_t{triangle.source - chunk.first_source}];
    const raster::VertexStreams& streams = buffers.streams;
    const auto corners = [&](const auto& stream) {
        const auto* first = &stream[instance.first_vertex];
        return std::array{first[index[0]], first[index[1]], first[index[2]]};
    };
    const auto [a, b, c] = corners(streams.position_world);
    points.position.set(i, (a + b + c) * (1.0f / 3.0f));
    points.normal.set(i, orientation * glm::cross(b - a, c - a));
    points.face_normal.set(i, points.normal.at(i));
    if (!streams.uv.empty()) {
        const auto [uv_a, uv_b, uv_c] = corners(streams.uv);
        set_uv((uv_a + uv_b + uv_c) * (1.0f / 3.0f), 0.5f * (uv_b - uv_a), 0.5f * (uv_c - uv_a), i, points);
    }
    if (!streams.tangent_world.empty()) {
        const auto [t_a, t_b, t_c] = corners(streams.tangent_world);
        set_tangent((t_a + t_b + t_c) * (1.0f / 3.0f), i, points);
    }
    if (behind) turn_point(i, points);
}

void light_vertices(const PassWork& work) {
    const RenderBuffers& buffers = work.frame.buffers;
    raster::VertexStreams& streams = work.frame.buffers.streams;
    for (const raster::MeshInstance& instance : buffers.instances) {
        for (std::size_t p = 0; p < instance.mesh->parts.size(); ++p) {
            const VertexRange range = vertices_of_part(*instance.mesh, instance.mesh->parts[p]);
            const auto material = static_cast<std::uint32_t>(instance.part_material[p]);
            if (!work.frame.plan.lighting.seen[material]) continue;
            const std::uint32_t first = instance.first_vertex + range.first;
            const int count = static_cast<int>(range.end - range.first);
            light_range(work, material, first, count, false, streams.color);
            if (work.frame.plan.two_sided) light_range(work, material, first, count, true, streams.color_behind);
        }
    }
}

void fog_vertices(const PassWork& work) {
    raster::VertexStreams& streams = work.frame.buffers.streams;
    for_each_batch(work, static_cast<int>(streams.fog.size()), [&](int begin, int count, TileScratch& scratch) {
        for (int i = 0; i < count; ++i) scratch.fragments->position.set(i, streams.position_world[begin + i]);
        lighting::fog_factors(*scratch.fragments, work.frame.lighting, *scratch.lighting);
        for (int i = 0; i < count; ++i) streams.fog[begin + i] = scratch.lighting->fog.at(i);
    });
}

void light_triangles(const PassWork& work) {
    RenderBuffers& buffers = work.frame.buffers;
    const int chunk_count = static_cast<int>(buffers.triangles.chunks.size());
    const std::size_t number = number_of(work.frame, work.pass);
#pragma omp parallel if (chunk_count > 1)
    {
        TileScratch& scratch = *buffers.scratch[static_cast<std::size_t>(thread_number())];
        scratch.clock.start();
#pragma omp for schedule(dynamic)
        for (int i = 0; i < chunk_count; ++i) {
            light_chunk(work.frame, buffers.triangles.chunks[i], buffers.flat_color[i], scratch);
            scratch.clock.lap(number);
        }
    }
}

}  // namespace kreda::scene
