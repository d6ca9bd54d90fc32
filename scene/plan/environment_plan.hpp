// What a scene requires of its environment, and what baking that costs.
#pragma once

#include <vector>

#include "scene/plan/choose_lighting.hpp"
#include "scene/plan/plan.hpp"

namespace kreda::scene {

/// What these materials, and the background, ask of the environment. all_levels: also what none of them reads.
[[nodiscard]] lighting::EnvironmentNeeds environment_needs(const Scene& scene, const MaterialMask& lit, bool background,
                                                           bool all_levels);

/// What everything in the scene that is not hidden may ask of it.
[[nodiscard]] lighting::EnvironmentNeeds environment_needs(const Scene& scene);

/// The passes that are run once, before the first frame, with their memory and cost.
[[nodiscard]] std::vector<PlannedPass> plan_baking(const Scene& scene, const lighting::EnvironmentNeeds& needs);

}  // namespace kreda::scene
