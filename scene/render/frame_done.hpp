// Where a test gets hold of every frame that a program draws.
#pragma once

#include "scene/render/frame.hpp"

namespace kreda::scene {

/// Called when a frame is complete and everything in it is still alive. It does nothing; a program that defines it
/// itself (tests/examples/watch_frames.cpp) is linked with its own.
void frame_done(const Frame& frame);

}  // namespace kreda::scene
