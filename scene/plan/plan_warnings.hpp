// What a scene says and nothing needs: found while it is planned.
#pragma once

#include <string>
#include <vector>

#include "scene/plan/plan.hpp"

namespace kreda::scene {

/// One line each, with what to do about it: lights that reach nothing, shadows that fall on nothing, objects of which
/// nothing is seen and why. None for a scene that is as it should be. The plan is one that leaves things out.
[[nodiscard]] std::vector<std::string> plan_warnings(const Scene& scene, const RenderPlan& plan);

}  // namespace kreda::scene
