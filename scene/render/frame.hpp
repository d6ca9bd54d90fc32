// What is the same for all points of a frame.
#pragma once

#include "lighting/batch/passes.hpp"
#include "scene/plan/plan.hpp"
#include "scene/scene.hpp"

namespace kreda::scene {

struct RenderBuffers;

struct Frame {
    const Scene& scene;
    const RenderPlan& plan;
    const lighting::LightingSetup& lighting;
    RenderBuffers& buffers;
};

}  // namespace kreda::scene
