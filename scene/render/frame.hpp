// What is the same for all points of a frame.
#pragma once

#include <cstddef>
#include <span>

#include <glm/mat4x4.hpp>

#include "lighting/batch/setup.hpp"
#include "scene/plan/plan.hpp"
#include "scene/scene.hpp"

namespace kreda::scene {

struct RenderBuffers;
struct RenderStatistics;

struct Frame {
    const Scene& scene;
    const RenderPlan& plan;
    const lighting::LightingSetup& lighting;
    RenderBuffers& buffers;
    RenderStatistics& statistics;
    glm::mat4 clip_from_world{1.0f};
    std::span<const PlannedPass> tile_passes;      ///< of the plan: those that are walked tile by tile
    std::span<const PlannedPass> lighting_passes;  ///< of the plan: those that are walked for every batch that is lit
    std::size_t pass_that_lights = 0;              ///< number of the pass that walks them
};

/// The number of a pass in the plan's list.
[[nodiscard]] inline std::size_t number_of(const Frame& frame, const PlannedPass& pass) {
    return static_cast<std::size_t>(&pass - frame.plan.passes.data());
}

}  // namespace kreda::scene
