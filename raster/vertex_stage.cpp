#include "raster/vertex_stage.hpp"

#include <algorithm>

#include <glm/matrix.hpp>

#include "raster/platform.hpp"

namespace kreda::raster {

namespace {

constexpr int kVerticesPerTask = 8192;

/// screen <- object for a run of vertices. What has no place on the screen is marked for the clipper.
KREDA_BATCH_LOOP void project_vertices(const glm::vec3* __restrict position_object, int count, glm::mat4 m,
                                       Viewport view, ScreenVertex* __restrict screen) {
    const float guard_x = guard_band_ndc(view.width);
    const float guard_y = guard_band_ndc(view.height);
    for (int i = 0; i < count; ++i) {
        const glm::vec4 clip = m * glm::vec4(position_object[i], 1.0f);
        const std::int32_t keep = inside_guard_band(clip, guard_x, guard_y) ? -1 : 0;
        const ScreenVertex vertex = to_screen(clip, view);
        screen[i].x = (vertex.x & keep) | (kNeedsClip & ~keep);  // a mask: with ?: GCC makes it a branch
        screen[i].y = vertex.y;
        screen[i].z = vertex.z;
        screen[i].inv_w = vertex.inv_w;
    }
}

/// world <- object for a run of positions (w stays 1).
KREDA_BATCH_LOOP void transform_points(const glm::vec3* __restrict in, int count, glm::mat4 m,
                                       glm::vec3* __restrict out) {
    for (int i = 0; i < count; ++i) out[i] = glm::vec3(m * glm::vec4(in[i], 1.0f));
}

/// world <- object for a run of normals.
KREDA_BATCH_LOOP void transform_normals(const glm::vec3* __restrict in, int count, glm::mat3 m,
                                        glm::vec3* __restrict out) {
    for (int i = 0; i < count; ++i) out[i] = m * in[i];
}

/// world <- object for a run of tangents. They lie in the surface and move with its points; a mirror swaps the side of
/// the bitangent.
KREDA_BATCH_LOOP void transform_tangents(const glm::vec4* __restrict in, int count, glm::mat3 m,
                                         glm::vec4* __restrict out) {
    const float side = is_mirrored(m) ? -1.0f : 1.0f;
    for (int i = 0; i < count; ++i) out[i] = glm::vec4(m * glm::vec3(in[i]), side * in[i].w);
}

/// One run of vertices of one instance through every transform that the streams have room for.
void transform_run(const MeshInstance& instance, const glm::mat4& clip_from_world, const Viewport& viewport,
                   std::uint32_t begin, int count, VertexStreams& streams) {
    const Mesh& mesh = *instance.mesh;
    const std::uint32_t to = instance.first_vertex + begin;
    project_vertices(&mesh.positions[begin], count, clip_from_world * instance.world_from_object, viewport,
                     &streams.screen[to]);
    if (!streams.position_world.empty()) {
        transform_points(&mesh.positions[begin], count, instance.world_from_object, &streams.position_world[to]);
    }
    if (!streams.normal_world.empty()) {
        transform_normals(&mesh.normals[begin], count, normal_from_object(instance.world_from_object),
                          &streams.normal_world[to]);
    }
    if (!streams.uv.empty() && !mesh.uvs.empty()) { std::copy_n(&mesh.uvs[begin], count, &streams.uv[to]); }
    if (!streams.tangent_world.empty() && !mesh.tangents.empty()) {
        transform_tangents(&mesh.tangents[begin], count, glm::mat3(instance.world_from_object),
                           &streams.tangent_world[to]);
    }
}

}  // namespace

std::uint32_t lay_out_vertices(std::vector<MeshInstance>& instances, const VertexNeeds& needs, VertexStreams& streams) {
    std::uint32_t count = 0;
    for (MeshInstance& instance : instances) {
        instance.first_vertex = count;
        count += static_cast<std::uint32_t>(instance.mesh->positions.size());
    }
    streams.screen.resize(count);
    streams.position_world.resize(needs.position_world ? count : 0);
    streams.normal_world.resize(needs.normal_world ? count : 0);
    streams.uv.assign(needs.uv ? count : 0, glm::vec2(0.0f));  // not every mesh has them
    streams.tangent_world.assign(needs.tangent_world ? count : 0, glm::vec4(0.0f));
    streams.color.resize(needs.color ? count : 0);
    streams.color_behind.resize(needs.color_behind ? count : 0);
    streams.fog.resize(needs.fog ? count : 0);
    return count;
}

bool is_mirrored(const glm::mat3& world_from_object) {
    return glm::determinant(glm::dmat3(world_from_object)) < 0.0;
}

glm::mat3 normal_from_object(const glm::mat4& world_from_object) {
    return glm::mat3(glm::transpose(glm::inverse(glm::dmat3(world_from_object))));
}

void transform_vertices(const std::vector<MeshInstance>& instances, const glm::mat4& clip_from_world,
                        const Viewport& viewport, VertexStreams& streams) {
    for (const MeshInstance& instance : instances) {
        const int total = static_cast<int>(instance.mesh->positions.size());
#pragma omp parallel for schedule(dynamic) if (total > kVerticesPerTask)
        for (int begin = 0; begin < total; begin += kVerticesPerTask) {
            const int count = std::min(kVerticesPerTask, total - begin);
            transform_run(instance, clip_from_world, viewport, static_cast<std::uint32_t>(begin), count, streams);
        }
    }
}

}  // namespace kreda::raster
