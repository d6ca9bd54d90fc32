// Walking the plan's list: the only place where passes of a frame are started.
#pragma once

#include <span>

#include "scene/render/frame.hpp"
#include "scene/render/render.hpp"

namespace kreda::scene {

/// The passes that are walked tile by tile: from the first that works on a tile to the end of the list.
[[nodiscard]] std::span<const PlannedPass> tile_passes_of(const RenderPlan& plan);

/// Those of the tile passes that are walked batch by batch.
[[nodiscard]] std::span<const PlannedPass> batch_passes_of(std::span<const PlannedPass> tile_passes);

/// The passes that are walked for every batch of points that is lit, wherever in the list.
[[nodiscard]] std::span<const PlannedPass> lighting_passes_of(const RenderPlan& plan);

/// Run what is baked. Nothing is, where the buffers or the scene hold it already.
void walk_baking(const Frame& frame, StageTimes& times);

/// Run all other passes, in the order of the list.
void walk_frame(const Frame& frame, StageTimes& times);

}  // namespace kreda::scene
