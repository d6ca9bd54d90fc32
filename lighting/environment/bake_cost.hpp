// What baking an environment costs, counted before anything is baked: for the plan, and for a bar that moves evenly.
// Operations as in scene/plan/plan_cost.hpp: one +, -, *, /, square root or comparison of one number.
#pragma once

#include <cstdint>
#include <vector>

#include "lighting/environment/environment.hpp"

namespace kreda::lighting {

/// One step of a bake and its result.
struct BakeCost {
    std::uint64_t count = 0;               ///< of what is summed: directions, samples, texels
    double operations_each = 0.0;          ///< floating-point operations for one of them
    std::uint64_t bytes = 0;               ///< of the map
    std::uint64_t bytes_while_baking = 0;  ///< of what is summed, where that is written down first

    /// All of them: count times operations_each.
    [[nodiscard]] double operations() const {
        return static_cast<double>(count) * operations_each;
    }
};

/// The environment as a cube map with all its mip levels, `size` texels a side, n x n directions a texel.
[[nodiscard]] BakeCost cube_cost(int size, int n);
/// The prefiltered levels, the mirror `size` texels a side.
[[nodiscard]] BakeCost prefilter_cost(int size, const PrefilterSettings& settings);
/// Irradiance from a cube of `size` texels a side.
[[nodiscard]] BakeCost irradiance_cost(int size, IrradianceForm form);
/// `maps` BRDF maps.
[[nodiscard]] BakeCost brdf_cost(std::size_t maps);

/// Operations of the steps of bake_environment, in its order: prefiltered levels, irradiance, BRDF maps; 0: not asked
/// for.
[[nodiscard]] std::vector<double> bake_work(int size, const EnvironmentNeeds& needs, int samples);

}  // namespace kreda::lighting
