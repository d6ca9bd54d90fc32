// Shadows that are found for all visible samples of a frame at once: planar, volume, irregular.
#pragma once

#include <vector>

#include "scene/render/frame.hpp"
#include "shadows/shadow.hpp"
#include "shadows/volume.hpp"

namespace kreda::scene {

/// What casts: the plan's objects, where the vertex stage put them, hidden parts left out. Points into the frame's
/// streams, so not to be kept over anything that appends to them.
struct Occluders {
    std::vector<shadows::Occluder> list;
    std::vector<std::vector<std::uint32_t>> indices;  ///< of those that have hidden parts
};
[[nodiscard]] Occluders find_occluders(const Frame& frame, const std::vector<int>& objects);

/// The same for shadow volumes, each with its vertices in the camera's clip space.
[[nodiscard]] std::vector<shadows::VolumeCaster> find_volume_casters(const Frame& frame, const PlannedShadow& planned,
                                                                     const Occluders& occluders);

/// After the triangles are set up and before anything is lit: one factor a sample in the memory of each of the plan's
/// shadows.
void find_frame_shadows(const Frame& frame, const glm::mat4& clip_from_world);

}  // namespace kreda::scene
