// What the plan says about shadows.
#pragma once

#include <cstdint>

#include "scene/plan/plan.hpp"
#include "scene/scene.hpp"

namespace kreda::scene {

/// The pass that finds a light's shadows, why, what it keeps in memory and what it costs.
[[nodiscard]] PlannedPass pass_of(const Scene& scene, const PlannedShadow& shadow, const raster::Viewport& viewport);

/// Bytes of the vertices and triangles that one map is drawn from, at most: fewer where its light sees fewer. 0 for
/// other methods.
[[nodiscard]] std::uint64_t bytes_to_draw(const Scene& scene, const PlannedShadow& shadow);

}  // namespace kreda::scene
