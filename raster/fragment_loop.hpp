// Visits every visible sample with its attributes, one after another. Simple and slow: examples use it for small
// pictures.
#pragma once

#include <functional>

#include "raster/fragments.hpp"

namespace kreda::raster {

/// Calls visit(x, y, fragments, i) for every covered sample: point i of the fragments holds its attributes.
void for_each_fragment(const VertexStreams& streams, const TriangleSet& triangles, const Viewport& viewport,
                       const FragmentNeeds& needs, AttributeInterpolation interpolation,
                       const std::function<void(int, int, const Fragments&, int)>& visit);

}  // namespace kreda::raster
