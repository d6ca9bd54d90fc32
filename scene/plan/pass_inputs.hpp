// What a pass reads, as bytes: of frames that follow each other a pass need not run again whose inputs are equal.
#pragma once

#include <string>

#include "scene/plan/shadow_plan.hpp"
#include "scene/scene.hpp"

namespace kreda::scene {

/// Everything that the map, or the tree, of one light is made from: the light, the settings, and each caster's mesh,
/// place and hidden parts. A mesh is told by its address: whoever keeps the bytes keeps the mesh, too.
[[nodiscard]] std::string shadow_inputs(const Scene& scene, const PlannedShadow& shadow);

}  // namespace kreda::scene
