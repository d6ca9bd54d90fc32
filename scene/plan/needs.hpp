// Which attributes of vertices and of visible samples the plan's passes read.
#pragma once

#include <vector>

#include "scene/plan/plan.hpp"

namespace kreda::scene {

/// Attributes of the vertex streams.
[[nodiscard]] raster::VertexNeeds vertex_needs(const RenderPlan& plan);

/// Attributes that are interpolated for the visible samples of each material.
[[nodiscard]] std::vector<raster::FragmentNeeds> fragment_needs(const Scene& scene, const RenderPlan& plan);

/// What any of them needs.
[[nodiscard]] raster::FragmentNeeds join(const std::vector<raster::FragmentNeeds>& of_material);

}  // namespace kreda::scene
