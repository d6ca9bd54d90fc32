// Compares a frame of the fast rasterizer with raster/rasterize_reference.cpp; tests ask for it.
#pragma once

#include "scene/render/frame.hpp"

namespace kreda::scene {

/// Where the environment variable KREDA_CHECK_VISIBILITY is set, draw the frame's triangles with
/// raster/rasterize_reference.cpp, too, and compare depth bits and triangle numbers of every sample. Says on stdout how
/// many were compared; throws std::logic_error at the first difference. Set for all examples by CTest ("visibility:
/// NN_name").
void check_visibility_if_asked(const Frame& frame);

}  // namespace kreda::scene
