#include "scene/render/frame_done.hpp"

namespace kreda::scene {

void frame_done(const Frame&) {}

}  // namespace kreda::scene
