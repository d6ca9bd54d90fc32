// The list of passes that a plan's decisions come to.
#pragma once

#include "scene/plan/plan.hpp"

namespace kreda::scene {

/// Does a pass work on points, batch by batch, and need memory for them?
[[nodiscard]] bool works_on_points(const PlannedPass& pass);

/// Fill plan.passes, in the order in which they run, from everything else that the plan says.
void list_passes(const Scene& scene, RenderPlan& plan);

}  // namespace kreda::scene
