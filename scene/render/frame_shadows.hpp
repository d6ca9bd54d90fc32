// Shadows that are found for all visible samples of a frame at once: planar, volume, irregular. The passes are
// collect_visible_samples() and make_frame_shadow(): one factor a sample in the memory of a planned shadow.
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
[[nodiscard]] Occluders collect_occluders(const Frame& frame, const std::vector<int>& objects);

/// The same for shadow volumes, each with its vertices in the camera's clip space.
[[nodiscard]] std::vector<shadows::VolumeCaster> collect_volume_casters(const Frame& frame,
                                                                        const PlannedShadow& planned,
                                                                        const Occluders& occluders);

}  // namespace kreda::scene
