// What a plan will cost, estimated before anything is drawn: arithmetic from counts of vertices, triangles, samples and
// lights, memory from the plan's buffers.
//
// One operation is one +, -, *, /, square root or comparison of one number, as the scalar formulas write them; pow
// counts 60 and exp 25, the lengths of their polynomials in raster/scalar_math.hpp. How many samples will be visible is
// not known yet: every sample counts, so costs of samples are upper bounds. It is an estimate to compare plans with;
// what a frame takes on a machine is measured by `kreda render --time`.
#pragma once

#include <string_view>

#include "lighting/material.hpp"
#include "scene/plan/plan.hpp"

namespace kreda::scene {

/// Sizes of the scene that costs and buffers depend on.
struct PlanCounts {
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    std::uint64_t drawn = 0;    ///< of them: those that reach the tiles; all of them where that is not known
    std::uint64_t samples = 0;  ///< of the whole picture
    std::uint64_t pixels = 0;
};
[[nodiscard]] PlanCounts count(const Scene& scene, const RenderPlan& plan);

/// Bytes of a triangle that is set up, with its entry in one tile.
inline constexpr std::uint64_t kTriangleBytes = sizeof(raster::ScreenTriangle) + sizeof(std::uint16_t);

/// Operations that one material's reflection of one light takes at one point, with adding it up. `one_half_vector`: the
/// light is directional and the projection parallel, so that Blinn's h is computed once a batch.
[[nodiscard]] double reflection_operations(const lighting::Material& material, bool one_half_vector = false);

/// Operations that sampling one light takes at one point.
[[nodiscard]] double light_operations(const lighting::Light& light);

// The passes' costs, but for those of shadows (shadow_cost.hpp) and of baking (lighting/environment/bake_cost.hpp).
[[nodiscard]] PassCost vertex_cost(const RenderPlan& plan, const PlanCounts& counts);
[[nodiscard]] PassCost vertex_fog_cost(const Scene& scene, const PlanCounts& counts);
[[nodiscard]] PassCost triangle_cost(const PlanCounts& counts);
[[nodiscard]] PassCost side_cost(const PlanCounts& counts);
[[nodiscard]] PassCost visibility_cost(const PlanCounts& counts);
[[nodiscard]] PassCost interpolation_cost(const RenderPlan& plan, const PlanCounts& counts);
[[nodiscard]] PassCost copy_cost(const PlanCounts& counts);
[[nodiscard]] PassCost fog_cost(const Scene& scene, const RenderPlan& plan, const PlanCounts& counts);
[[nodiscard]] PassCost mix_fog_cost(const RenderPlan& plan, const PlanCounts& counts);
[[nodiscard]] PassCost film_cost(const RenderPlan& plan, const PlanCounts& counts);

// Costs of light, wherever it is computed: at samples, vertices or triangles.
[[nodiscard]] PassCost sum_cost(const RenderPlan& plan, const PlanCounts& counts);
[[nodiscard]] PassCost surface_cost(const RenderPlan& plan, const PlanCounts& counts);
[[nodiscard]] PassCost map_cost(const RenderPlan& plan, const PlanCounts& counts, std::size_t maps);
[[nodiscard]] PassCost environment_light_cost(const Scene& scene, const RenderPlan& plan, const PlanCounts& counts);
[[nodiscard]] PassCost light_cost(const Scene& scene, const RenderPlan& plan, const PlanCounts& counts, int light);

/// Operations of a pass of that name together with those of the passes that it runs, batch by batch: of "light pixels"
/// all that light takes. 0: the plan has no such pass.
[[nodiscard]] double operations_of(const RenderPlan& plan, std::string_view pass);

/// Operations of what is baked before the first frame.
[[nodiscard]] double baking_operations(const RenderPlan& plan);

/// Operations of all passes of a frame together.
[[nodiscard]] double total_operations(const RenderPlan& plan);

/// Bytes of all buffers together, those of a tile or batch once.
[[nodiscard]] std::uint64_t total_bytes(const RenderPlan& plan);

}  // namespace kreda::scene
