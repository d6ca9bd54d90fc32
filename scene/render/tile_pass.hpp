// Everything that happens to one tile: visibility, fragments, lighting, fog, film.
#pragma once

#include "lighting/batch/passes.hpp"
#include "raster/fragments.hpp"
#include "scene/render/frame.hpp"
#include "scene/render/render.hpp"
#include "scene/render/stopwatch.hpp"

namespace kreda::scene {

/// Linear RGB of a tile's samples, or the one or three numbers of a view.
struct TileColor {
    alignas(64) float plane[3][raster::kTileSide * raster::kTileSide];
};

/// What one thread needs to work on a tile.
struct TileScratch {
    raster::TileVisibility visibility;
    raster::Run runs[raster::kTileSide * raster::kTileSide];
    raster::Fragments fragments;
    lighting::LightingChannels lighting;
    TileColor color;
    bool color_is_background = false;  ///< nothing was drawn in the tile before: the next one can start with its colour
    std::vector<TileColor> views;      ///< one for each of the plan's
    Stopwatch watch;                   ///< one for all stages of all tiles: asking the time costs some, too
    double visibility_ms = 0.0, interpolation_ms = 0.0, lighting_ms = 0.0, film_ms = 0.0;
    std::uint64_t samples_shaded = 0;
};

/// Work through one tile and write its pixels to buffers.film and buffers.views.
void render_tile(const Frame& frame, int tile_index, TileScratch& scratch);

/// One batch of a tile: interpolate, light, fog, back into scratch.color. What the passes wrote on the way stays in
/// scratch.fragments and scratch.lighting. The runs share a material and hold at most kBatchCapacity samples.
void work_batch(const Frame& frame, const raster::TileArea& area, const raster::Run* runs, int count,
                TileScratch& scratch);

}  // namespace kreda::scene
