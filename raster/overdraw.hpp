// Overdraw: how many triangles lie over each sample. What a depth buffer saves, and the proof that shared edges are
// exact.
#pragma once

#include <cstdint>
#include <vector>

#include "raster/triangle_setup.hpp"

namespace kreda::raster {

/// For each sample, row 0 on top: how many triangles of the set cover its centre, whatever their depth.
/// For a closed surface the front faces (CullMode::back) cover a sample as often as the back faces (CullMode::front).
[[nodiscard]] std::vector<std::uint32_t> count_overdraw(const VertexStreams& streams, const TriangleSet& set,
                                                        const Viewport& viewport);

}  // namespace kreda::raster
