// Shading at a lower rate than the samples': of a block of samples, those that see the same triangle share one point
// that is lit. Edges stay as fine as the samples, for a block that several triangles share has a point for each of
// them.
#pragma once

#include <cstdint>

#include "raster/fragments.hpp"
#include "raster/rasterize_tile.hpp"

namespace kreda::raster {

/// Greatest side of a block.
inline constexpr int kLargestShadingRate = 8;

/// For every sample of a tile: the sample, row * kTileSide + column, that is lit in its place; itself where nothing is
/// seen.
struct ShadingPoints {
    std::uint16_t of[kTileSide * kTileSide];  ///< by the sample's own number
};

/// The points of a tile, cut into blocks of rate x rate samples from its upper left corner: in each block, for each
/// triangle that is seen there, the sample nearest to the block's middle, the first of several in reading order. Each
/// becomes a run of one sample, or of every rate-th where a triangle fills block after block. `runs` has room for one a
/// sample. Returns their number.
int collect_shading_points(const TileVisibility& tile, const TileArea& area, const TriangleSet& set, int rate,
                           Run* runs, ShadingPoints& points);

/// Give every sample what its point has. plane: kTileSide x kTileSide numbers.
void spread(const ShadingPoints& points, const TileArea& area, float* plane);

}  // namespace kreda::raster
