// What a scene requires of its environment, and what baking that costs.
#pragma once

#include <vector>

#include "scene/plan/plan.hpp"

namespace kreda::scene {

/// What the materials that are seen, and the background, ask of the environment.
[[nodiscard]] lighting::EnvironmentNeeds environment_needs(const Scene& scene);

/// The passes that are run once, before the first frame, with their memory and cost.
[[nodiscard]] std::vector<PlannedPass> plan_baking(const Scene& scene, const lighting::EnvironmentNeeds& needs);

}  // namespace kreda::scene
