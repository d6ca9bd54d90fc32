// The fast rasterizer: one tile at a time, sixteen samples of a row side by side. Same bits as the reference.
#pragma once

#include <cstdint>

#include "raster/triangle_setup.hpp"
#include "raster/visibility.hpp"

namespace kreda::raster {

/// Depth alone of the samples of one tile: all that a shadow map asks for, 16 KB.
struct TileDepth {
    alignas(64) float depth[kTileSide * kTileSide];  ///< window depth, 0 near .. 1 far
};

/// Depth and triangle number of the samples of one tile: 32 KB, at home in the first-level cache.
struct TileVisibility {
    alignas(64) float depth[kTileSide * kTileSide];             ///< window depth, 0 near .. 1 far
    alignas(64) std::uint32_t triangle[kTileSide * kTileSide];  ///< triangle_id(), or kNoTriangle
};

/// A tile's place on the sample grid.
struct TileArea {
    int x = 0, y = 0;           ///< its first sample
    int width = 0, height = 0;  ///< at most kTileSide; less at the right and lower border of the image
    int index = 0;              ///< row * columns + column
};

/// The samples of tile number `index`, cut at the picture's border.
[[nodiscard]] TileArea tile_area(const TileGrid& grid, const Viewport& viewport, int index);

/// Whether any triangle of the set touches the tile; if none does, there is nothing to draw in it.
[[nodiscard]] bool any_triangle_touches(const TriangleSet& set, const TileArea& area);

/// Clear the tile and draw all triangles of the set that touch it, in order.
void rasterize_tile(const VertexStreams& streams, const TriangleSet& set, const TileArea& area, TileVisibility& tile);
/// The same depths without the triangles that they belong to.
void rasterize_tile(const VertexStreams& streams, const TriangleSet& set, const TileArea& area, TileDepth& tile);

/// The whole image tile by tile (for tests and for stages that look at the whole buffer).
[[nodiscard]] VisibilityBuffer rasterize_tiled(const VertexStreams& streams, const TriangleSet& set,
                                               const Viewport& viewport);

}  // namespace kreda::raster
