// Which lights reach a seen sample, where lamps are asked at every sample.
#pragma once

#include <vector>

#include "scene/plan/placed.hpp"
#include "scene/plan/seen.hpp"

namespace kreda::scene {

/// Of seen.reached, which is a bound by triangles, keep what holds for a seen sample: light arrives at it, and it faces
/// the light. The samples are interpolated as the renderer does it. Where a map bends normals any of them may face it.
/// tile_of_material: a tile that shows the material, -1 if none does; looked at first, since it mostly answers.
void keep_what_reaches_samples(const Scene& scene, const RenderPlan& plan, const Placed& placed,
                               const std::vector<int>& tile_of_material, Seen& seen);

}  // namespace kreda::scene
