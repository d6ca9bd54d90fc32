// A scene on the sample grid before it is drawn: what the plan looks at.
#pragma once

#include <vector>

#include "raster/triangle_setup.hpp"
#include "raster/vertex_stage.hpp"

namespace kreda::scene {

/// What the passes "vertices", "triangles" and "sides" leave.
struct Placed {
    std::vector<raster::MeshInstance> instances;
    raster::VertexStreams streams;
    raster::TriangleSet triangles;
};

}  // namespace kreda::scene
