// What shadows will cost, estimated as plan_cost.hpp says: what is done once a frame for each light, and what every
// point asks.
#pragma once

#include <cstdint>

#include "scene/plan/plan.hpp"

namespace kreda::scene {

/// The pass before anything is shaded. `samples`: of the picture. How much of the picture the triangles of a volume or
/// on a plane cover is not known yet: each caster counts as covering all of it, once a face.
[[nodiscard]] PassCost shadow_pass_cost(const Scene& scene, const PlannedShadow& shadow, std::uint64_t samples);

/// Operations to find the shadow at one point, at most.
[[nodiscard]] double shadow_look_up_operations(const Scene& scene, const PlannedShadow& shadow);

}  // namespace kreda::scene
