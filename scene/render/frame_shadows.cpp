#include "scene/render/frame_shadows.hpp"

#include <algorithm>
#include <cstddef>

#include <glm/matrix.hpp>

#include "scene/plan/pass_functions.hpp"
#include "scene/render/pass_work.hpp"
#include "scene/render/render.hpp"
#include "scene/render/shadow_pass.hpp"
#include "shadows/irregular.hpp"
#include "shadows/planar.hpp"
#include "shadows/volume.hpp"

namespace kreda::scene {

namespace {

using raster::MeshInstance;

std::vector<std::uint32_t> visible_indices(const MeshInstance& instance) {
    std::vector<std::uint32_t> indices;
    for (std::size_t p = 0; p < instance.mesh->parts.size(); ++p) {
        if (instance.part_hidden[p]) continue;
        const raster::MeshPart& part = instance.mesh->parts[p];
        const auto begin = instance.mesh->indices.begin() + 3 * static_cast<std::ptrdiff_t>(part.first_triangle);
        indices.insert(indices.end(), begin, begin + 3 * static_cast<std::ptrdiff_t>(part.triangle_count));
    }
    return indices;
}

bool has_hidden_parts(const MeshInstance& instance) {
    return std::find(instance.part_hidden.begin(), instance.part_hidden.end(), true) != instance.part_hidden.end();
}

void find_planar(const Frame& frame, const PlannedShadow& planned, const Occluders& occluders,
                 std::vector<float>& factor) {
    const shadows::VisibleSampleMemory& visible = frame.buffers.visible;
    const raster::TriangleSet& triangles = frame.buffers.triangles;
    std::vector<float> on_plane(factor.size());
    for (const ShadowReceiver& receiver : planned.receivers) {
        planar_shadow(occluders.list, receiver.plane, planned.source, visible.samples(), on_plane);
        for (std::size_t i = 0; i < factor.size(); ++i) {
            const std::uint32_t seen = visible.triangle[i];
            if (seen == raster::kNoTriangle) continue;
            const std::uint32_t object = triangles.chunks[seen >> raster::kChunkShift].instance;
            if (object == static_cast<std::uint32_t>(receiver.object)) factor[i] = on_plane[i];
        }
    }
}

void find_volume_shadow(const Frame& frame, const PlannedShadow& planned, const Occluders& occluders,
                        std::vector<float>& factor) {
    volume_shadow(collect_volume_casters(frame, planned, occluders), planned.source, frame.buffers.visible.samples(),
                  factor);
}

}  // namespace

Occluders collect_occluders(const Frame& frame, const std::vector<int>& objects) {
    Occluders occluders;
    occluders.indices.resize(objects.size());
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const MeshInstance& instance = frame.buffers.instances[static_cast<std::size_t>(objects[i])];
        if (has_hidden_parts(instance)) occluders.indices[i] = visible_indices(instance);
        const glm::vec3* positions = frame.buffers.streams.position_world.data() + instance.first_vertex;
        occluders.list.push_back({{positions, instance.mesh->positions.size()},
                                  has_hidden_parts(instance) ? occluders.indices[i] : instance.mesh->indices,
                                  raster::is_mirrored(glm::mat3(instance.world_from_object))});
    }
    return occluders;
}

std::vector<shadows::VolumeCaster> collect_volume_casters(const Frame& frame, const PlannedShadow& planned,
                                                          const Occluders& occluders) {
    std::vector<shadows::VolumeCaster> casters;
    for (std::size_t i = 0; i < planned.casters.size(); ++i) {
        const MeshInstance& instance = frame.buffers.instances[static_cast<std::size_t>(planned.casters[i])];
        casters.push_back(
            {occluders.list[i], shadows::clip_positions(instance, frame.buffers.visible.clip_from_world)});
    }
    return casters;
}

void collect_visible_samples(const PassWork& work) {
    const Frame& frame = work.frame;
    shadows::find_visible(frame.buffers.streams, frame.buffers.triangles, frame.plan.interpolation, frame.plan.viewport,
                          frame.clip_from_world, frame.buffers.visible);
}

void make_frame_shadow(const PassWork& work) {
    const Frame& frame = work.frame;
    if (frame.buffers.visible.depth.empty()) return;
    const PlannedShadow& planned = frame.plan.shadows[static_cast<std::size_t>(work.pass.index)];
    const Occluders occluders = collect_occluders(frame, planned.casters);
    std::vector<float>& factor = frame.buffers.shadows[static_cast<std::size_t>(work.pass.index)].factor;
    factor.assign(frame.buffers.visible.depth.size(), 1.0f);
    switch (planned.map.settings.method) {
        case shadows::ShadowMethod::planar: find_planar(frame, planned, occluders, factor); break;
        case shadows::ShadowMethod::volume: find_volume_shadow(frame, planned, occluders, factor); break;
        case shadows::ShadowMethod::irregular:
            irregular_shadow(occluders.list, planned.source, frame.buffers.visible.samples(), factor);
            break;
        case shadows::ShadowMethod::map:
        case shadows::ShadowMethod::exact: break;  // asked point by point
    }
}

}  // namespace kreda::scene
