// What a pass is handed when it runs: PlannedPass::run(work).
#pragma once

#include <cstdint>

#include "raster/fragments.hpp"
#include "scene/render/frame.hpp"

namespace kreda::scene {

struct TileScratch;

struct PassWork {
    const Frame& frame;
    const PlannedPass& pass;
    TileScratch& scratch;               ///< this thread's memory
    raster::TileArea area = {};         ///< of the tile, for PassScope::tile and batch
    const raster::Run* runs = nullptr;  ///< of the batch, for PassScope::batch
    int run_count = 0;
    std::uint32_t material = 0;                      ///< of the batch, for PassScope::batch and points
    const raster::Fragments* points = nullptr;       ///< to be lit, for PassScope::points
    lighting::LightingChannels* channels = nullptr;  ///< of those points
};

}  // namespace kreda::scene
