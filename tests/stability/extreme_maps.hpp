// Random maps and environment images that hold everything a file may hold after it was read, at the ends of what is
// allowed.
#pragma once

#include <cstdint>

#include "scene/scene.hpp"

namespace kreda::tests {

/// Give one scene of two maps of every kind in place of its constants, and where it has an environment an image with
/// black and very bright texels. The same seed gives the same maps.
void add_extreme_maps(scene::Scene& scene, std::uint32_t seed);

}  // namespace kreda::tests
