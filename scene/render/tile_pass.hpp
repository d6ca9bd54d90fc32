// Everything that happens to one tile: visibility, fragments, lighting, fog, film.
#pragma once

#include "lighting/batch/passes.hpp"
#include "raster/display_bytes.hpp"
#include "raster/fragments.hpp"
#include "raster/shading_points.hpp"
#include "scene/render/frame.hpp"
#include "scene/render/pass_clock.hpp"
#include "scene/render/render.hpp"

namespace kreda::scene {

/// Linear RGB of a tile's samples, or the one or three numbers of a view.
struct TileColor {
    alignas(64) float plane[3][raster::kTileSide * raster::kTileSide];
};

/// What one thread needs to work on a tile.
struct TileScratch {
    raster::TileVisibility visibility;
    raster::Run runs[raster::kTileSide * raster::kTileSide];
    int run_count = 0;
    std::unique_ptr<raster::ShadingPoints> points;         ///< only where not every sample is lit
    bool points_are_chosen = false;                        ///< of this tile
    std::unique_ptr<raster::Fragments> fragments;          ///< only where a pass works on points
    std::unique_ptr<lighting::LightingChannels> lighting;  ///< with them, and for an environment behind the objects
    TileColor color;
    bool color_is_background = false;  ///< nothing was drawn in the tile before: the next one can start with its colour
    std::vector<TileColor> views;      ///< one for each of the plan's
    PassClock clock;
    raster::ShownValues shown;  ///< by the tiles of this thread
    std::uint64_t samples_shaded = 0;
};

/// The colour of a flat triangle, lit once.
[[nodiscard]] inline glm::vec3 flat_color_of(const RenderBuffers& buffers, std::uint32_t id) {
    return buffers.flat_color[id >> raster::kChunkShift][id & ((1u << raster::kChunkShift) - 1)];
}

/// Work through one tile and write its pixels to buffers.film and buffers.views: run the frame's tile passes in order,
/// those of batches batch by batch.
void render_tile(const Frame& frame, int tile_index, TileScratch& scratch);

/// All tiles, side by side.
void render_tiles(const Frame& frame);

/// Run these passes on one batch of a tile. What they wrote on the way stays in scratch.fragments and
/// scratch.lighting. The runs share a material and hold at most kBatchCapacity samples.
void work_batch(const Frame& frame, const raster::TileArea& area, std::span<const PlannedPass> passes,
                const raster::Run* runs, int count, TileScratch& scratch);

/// Make the thread's memory ready for a frame: what the plan's passes work on is there, times and counts at zero.
void fit_scratch(const RenderPlan& plan, TileScratch& scratch);

}  // namespace kreda::scene
