// The list of passes that a plan's decisions come to.
#pragma once

#include "scene/plan/plan.hpp"

namespace kreda::scene {

/// Fill plan.passes, in the order in which they run, from everything else that the plan says.
void list_passes(const Scene& scene, RenderPlan& plan);

/// Which side of a triangle is seen is asked only where normals are interpolated.
[[nodiscard]] bool finds_sides(const RenderPlan& plan);

}  // namespace kreda::scene
