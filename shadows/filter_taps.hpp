// What a filter read on its way to one point's shadow, tap by tap, by the loops that draw the picture: for
// explanations.
#pragma once

#include <vector>

#include "shadows/map_points.hpp"
#include "shadows/soft_filter.hpp"

namespace kreda::shadows {

/// A texel that was compared, or a cell of texels of which the one in the middle was.
struct FilterTap {
    float u = 0.0f, v = 0.0f;  ///< its centre, texels from the upper left corner
    float stored = 0.0f;       ///< the map's distance there, world units; kNoCaster where nothing casts
    float compared = 0.0f;     ///< the surface's distance there, less the bias
    float lit = 0.0f;          ///< of the weight, what is lit; in a search: 1 where the cell blocks a part of the light
    float weight = 1.0f;       ///< area within the filter, in texels²; a texel of pcf counts 1
};

/// The (2 radius + 1)^2 texels that pcf compares for point 0, row by row; radius 0 without a filter.
[[nodiscard]] std::vector<FilterTap> box_taps(const ShadowMap& map, const MapPoints& points, int radius);

/// What pcss did for point 0.
struct SoftTaps {
    float search_half_u = 0.0f, search_half_v = 0.0f;  ///< half the search's window, texels
    std::vector<FilterTap> search;                     ///< its cells
    float blocker = 0.0f;                              ///< mean distance of those that block
    bool blocked = false;                              ///< some block
    float half_u = 0.0f, half_v = 0.0f;                ///< half the penumbra in the map, at least half a texel
    std::vector<FilterTap> filter;                     ///< cells that lie in it
};
/// The map and the points as the soft filter reads them.
[[nodiscard]] SoftTaps soft_taps(const ShadowMap& map, const MapPoints& points);

}  // namespace kreda::shadows
