// The frame's grid of tiles.
#pragma once

#include <cstdint>

#include "raster/judge_triangle.hpp"
#include "raster/screen.hpp"

namespace kreda::raster {

/// The screen is worked on in square tiles that fit into the processor's first cache.
inline constexpr int kTileSide = 64;

/// The frame's grid of tiles over the sample grid.
struct TileGrid {
    int tile_side = kTileSide;  ///< samples a side, at most kTileSide
    int columns = 0;            ///< tiles side by side; the last may be narrower
    int rows = 0;               ///< tiles one below the other

    /// sample / tile_side without a division: exact for 0 <= sample < kMaxImageSide, because the error of the
    /// reciprocal, sample / 2^20 < 1/64, never reaches the next tile.
    [[nodiscard]] std::uint16_t tile_of(std::int32_t sample) const {
        return static_cast<std::uint16_t>(static_cast<std::uint32_t>(sample) * reciprocal >> 20);
    }
    std::uint32_t reciprocal = (1u << 20) / kTileSide;  ///< 2^20 / tile_side, rounded up
};

/// The tiles that a triangle's samples may lie in, inclusive.
struct TileRange {
    std::uint16_t x0, y0, x1, y1;  ///< columns x0..x1, rows y0..y1
};

/// The tiles that a box of samples touches.
inline TileRange tiles_of(const TileGrid& grid, const SampleRange& x, const SampleRange& y) {
    return {grid.tile_of(x.first), grid.tile_of(y.first), grid.tile_of(x.last), grid.tile_of(y.last)};
}

/// Tiles whose side is a multiple of `samples`, so that a pixel's samples never lie in two tiles.
inline TileGrid make_tile_grid(const Viewport& viewport, int samples) {
    TileGrid grid;
    grid.tile_side = kTileSide / samples * samples;
    const std::uint32_t side = static_cast<std::uint32_t>(grid.tile_side);
    grid.reciprocal = ((1u << 20) + side - 1) / side;
    grid.columns = (viewport.width + grid.tile_side - 1) / grid.tile_side;
    grid.rows = (viewport.height + grid.tile_side - 1) / grid.tile_side;
    return grid;
}

}  // namespace kreda::raster
