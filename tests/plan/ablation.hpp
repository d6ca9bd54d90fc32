// Every pass earns its place: what changes when one of them is left out.
#pragma once

#include <string>
#include <vector>

#include "scene/plan/plan.hpp"
#include "scene/render/render.hpp"

namespace kreda::tests {

/// What an ablation found, added up over scenes.
struct AblationReport {
    int passes = 0;                    ///< that were left out, one at a time
    std::vector<std::string> idle;     ///< of them: nothing changed, and the plan says why that may be
    std::vector<std::string> useless;  ///< nothing changed, and the plan gives no reason
    std::vector<std::string> missing;  ///< the plan that leaves nothing out draws another picture
};

/// Draw the film, or the views asked for, with each of the plan's passes left out in turn, and once with the plan that
/// leaves nothing out. `name` is what messages call the scene.
void ablate(const scene::Scene& scene, const scene::PlanRequest& request, const std::string& name,
            AblationReport& report);

}  // namespace kreda::tests
