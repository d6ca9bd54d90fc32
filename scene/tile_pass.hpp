// Everything that happens to one tile: visibility, fragments, lighting, fog, film.
#pragma once

#include "lighting/passes.hpp"
#include "raster/fragments.hpp"
#include "scene/render.hpp"

namespace kreda::scene {

/// Linear RGB of a tile's samples.
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
    double visibility_ms = 0.0, interpolation_ms = 0.0, lighting_ms = 0.0, film_ms = 0.0;
    std::uint64_t samples_shaded = 0;
};

/// What is the same for all tiles of a frame.
struct TileFrame {
    const Scene& scene;
    const RenderPlan& plan;
    const lighting::LightingSetup& lighting;
    RenderBuffers& buffers;
};

/// Work through one tile and write its pixels to buffers.film.
void render_tile(const TileFrame& frame, int tile_index, TileScratch& scratch);

}  // namespace kreda::scene
