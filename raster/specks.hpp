// Specks: what a crease cuts out of a surface that goes on around it, the noise of a scanner.
#pragma once

#include <cstdint>
#include <vector>

#include "raster/corner_clusters.hpp"

namespace kreda::raster {

/// A speck is a region of one to three triangles, bounded by creases, that has more than half of its edges in common
/// with one region of at least 16 times as many triangles. Its edges to that region are no creases any more.
void smooth_over_specks(std::uint32_t triangles, const std::vector<SharedEdge>& edges, std::vector<bool>& is_crease);

}  // namespace kreda::raster
