// What the plan says about shadows.
#pragma once

#include "scene/plan/plan.hpp"
#include "scene/scene.hpp"

namespace kreda::scene {

/// The pass that finds a light's shadows, why, what it keeps in memory and what it costs.
[[nodiscard]] PlannedPass pass_of(const Scene& scene, const PlannedShadow& shadow, const raster::Viewport& viewport);

}  // namespace kreda::scene
