// Called by a debugger from a stopped program, `save-png IMAGE FILE`: nothing in the program calls these.
#pragma once

#include "raster/image.hpp"
#include "raster/visibility.hpp"
#include "scene/render/frame.hpp"
#include "scene/render/render.hpp"

// Each writes an 8-bit PNG and returns whether it could; why it could not goes to stderr. C names, because the linker
// is told to keep them: see CMakeLists.txt.
extern "C" {
/// Linear RGB, or linear grey.
bool kreda_save_image(const kreda::raster::Image* image, const char* path);
/// Depth as grey: the nearest white, the farthest dark, nothing black.
bool kreda_save_visibility(const kreda::raster::VisibilityBuffer* buffer, const char* path);
/// The same for a tile of kTileSide x kTileSide samples.
bool kreda_save_tile(const kreda::raster::TileVisibility* tile, const char* path);
/// The depth of all samples of the picture that is being drawn: every tile is rasterized anew.
bool kreda_save_frame_depth(const kreda::scene::Frame* frame, const char* path);
/// The picture as far as it is drawn.
bool kreda_save_frame_film(const kreda::scene::Frame* frame, const char* path);
}
