// What is odd but not wrong about the shadows that a scene asks for.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace kreda::scene {

/// A line each: occluders of shadow volumes that are not closed, planar shadows without a plane, a ground so wide that
/// the map of parallel rays has few texels for what stands on it.
[[nodiscard]] std::vector<std::string> shadow_warnings(const Scene& scene);

}  // namespace kreda::scene
