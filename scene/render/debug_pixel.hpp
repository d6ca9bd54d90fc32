// Where a debugger gets hold of one pixel: tools/debugger/ has the commands for it, docs/debugging.md shows them.
//
// A breakpoint with a condition, "stop if x is 300 and y is 400", stops the program at every pixel and asks: minutes
// for one picture. Here the program itself asks, once a tile, and calls an empty function at the right moment.
#pragma once

#include <glm/vec2.hpp>

#include "raster/fragments.hpp"

namespace kreda::scene {

/// A pixel of the picture that is being drawn; row 0 is on top. x = -1: none.
struct DebugPixel {
    int x = -1;
    int y = -1;
};

/// The pixel that a debugger wants to see. The program never writes it, and it is the project's only variable outside
/// of a function: a debugger has no other way in.
extern DebugPixel debug_pixel;

/// A debugger breaks here: a picture of this size begins, and debug_pixel may be set for it.
[[gnu::noinline]] void picture_begins(int width, int height);

/// A debugger breaks here: the pixel it wants is shaded next, in a batch of its own, so that every formula runs once.
[[gnu::noinline]] void pixel_reached(int x, int y);

/// A debugger breaks here: no triangle covers the pixel it wants (with supersampling: the pixel's middle sample).
[[gnu::noinline]] void pixel_not_covered(int x, int y);

/// Where in this tile is the sample that stands for the wanted pixel, the middle one of n x n? {-1, -1}: not in this
/// tile.
[[nodiscard]] glm::ivec2 sample_to_debug(const raster::TileArea& area, int n);

/// Cut the run that holds a sample of the tile into up to three, so that the sample is a run of its own. Returns that
/// run's place, or run_count when no run holds the sample. `runs` has room for one run a sample.
[[nodiscard]] int cut_out_sample(raster::Run* runs, int& run_count, const glm::ivec2& sample);

}  // namespace kreda::scene
