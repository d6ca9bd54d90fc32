// What is odd but not wrong about the shadows that a scene asks for.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace kreda::scene {

/// A line each: occluders of shadow volumes that are not closed, planar shadows without a plane.
[[nodiscard]] std::vector<std::string> shadow_warnings(const Scene& scene);

}  // namespace kreda::scene
