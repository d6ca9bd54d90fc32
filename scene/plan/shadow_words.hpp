// What the plan and the reader say about shadows.
#pragma once

#include "scene/plan/plan.hpp"
#include "scene/scene.hpp"

namespace kreda::scene {

/// The pass that finds a light's shadows, why, what it keeps in memory and what it costs.
[[nodiscard]] PlannedPass pass_of(const Scene& scene, const PlannedShadow& shadow, const raster::Viewport& viewport);

/// What is odd but not wrong about the scene's shadows, a line each: occluders of shadow volumes that are not closed,
/// planar shadows without a plane.
[[nodiscard]] std::vector<std::string> shadow_warnings(const Scene& scene);

}  // namespace kreda::scene
