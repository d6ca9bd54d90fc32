// The farthest depth of a tile: what lies behind it is hidden and needs no look at its samples.
#pragma once

#include <algorithm>

#include "raster/rasterize_tile.hpp"
#include "raster/scalar_math.hpp"

namespace kreda::raster {

/// A hierarchy of two levels: the depth of each sample, and one that none of the tile's lies behind. A triangle that is
/// nowhere nearer than that is hidden, and its samples are not asked.                    after Greene, Kass & Miller
/// 1993
struct FarthestDepth {
    float z = kInfinity;  ///< at least the depth of every sample of the tile
    int drawn = 0;        ///< samples in the boxes of triangles since it was looked for; each may have come nearer

    /// Is a triangle hidden whose nearest corner has that depth?
    [[nodiscard]] bool hides(float nearest) const {
        return nearest >= z;  // equal depths: the first stays
    }
};

/// It is looked for each time that triangles whose boxes cover the tile four times over were drawn.
inline constexpr int kSamplesBetweenLooks = 4 * kTileSide * kTileSide;

/// The farthest of the depths of a tile, which may end within its memory. All columns are asked side by side.
inline float farthest_depth(const TileArea& area, const float* depth) {
    float farthest[kTileSide] = {};
    for (int y = 0; y < area.height; ++y, depth += kTileSide) {
        for (int x = 0; x < kTileSide; ++x) {
            const float z = x < area.width ? depth[x] : 0.0f;
            farthest[x] = z > farthest[x] ? z : farthest[x];
        }
    }
    return *std::max_element(farthest, farthest + kTileSide);
}

}  // namespace kreda::raster
