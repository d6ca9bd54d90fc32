// The lecture's rasterizer: bounding box, three edge functions, depth test. Slow, short, and the judge of the fast one.
#pragma once

#include "raster/triangle_setup.hpp"
#include "raster/visibility.hpp"

namespace kreda::raster {

/// Draw one triangle into the buffer: every sample centre inside it whose depth is smaller than what is there.
void rasterize_triangle(const VertexStreams& streams, const ScreenTriangle& triangle, std::uint32_t id,
                        VisibilityBuffer& buffer);

/// Draw all triangles of a set, in order, into a cleared buffer.
[[nodiscard]] VisibilityBuffer rasterize_reference(const VertexStreams& streams, const TriangleSet& set,
                                                   const Viewport& viewport);

}  // namespace kreda::raster
