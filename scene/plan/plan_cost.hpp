// What a plan will cost, estimated before anything is drawn: arithmetic from counts of vertices, triangles, samples and
// lights, memory from the plan's buffers.
//
// One operation is one +, -, *, /, square root or comparison of one number, as the scalar formulas write them; pow
// counts 60 and exp 25, the lengths of their polynomials in raster/scalar_math.hpp. How many samples will be visible is
// not known yet: every sample counts, so costs of samples are upper bounds. It is an estimate to compare plans with;
// what a frame takes on a machine is measured by `kreda render --time`.
#pragma once

#include "lighting/material.hpp"
#include "scene/plan/plan.hpp"

namespace kreda::scene {

/// Operations that one material's reflection of one light takes at one point, with adding it up.
[[nodiscard]] double reflection_operations(const lighting::Material& material);

/// Operations that sampling one light takes at one point.
[[nodiscard]] double light_operations(const lighting::Light& light);

/// Fill in PlannedPass::cost of every pass of the plan that is known here; shadows have theirs (shadow_cost.hpp).
void estimate_costs(const Scene& scene, RenderPlan& plan);

/// Operations of what is baked before the first frame.
[[nodiscard]] double baking_operations(const RenderPlan& plan);

/// Operations of all passes of a frame together.
[[nodiscard]] double total_operations(const RenderPlan& plan);

/// Bytes of all buffers together, those of a tile or batch once.
[[nodiscard]] std::uint64_t total_bytes(const RenderPlan& plan);

}  // namespace kreda::scene
