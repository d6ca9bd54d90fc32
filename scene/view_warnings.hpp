// Cameras that show nothing, because everything is cut away or lies elsewhere, or have too few depths to tell surfaces
// apart.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace kreda::scene {

/// One sentence each; empty for a scene without objects.
[[nodiscard]] std::vector<std::string> view_warnings(const Scene& scene);

/// How far apart two surfaces must lie at this distance along the view to get two depths, in world units: the step
/// of float below 1, 2^-24, over the slope of the window depth (docs/95_depth_precision.md, equation 2).
[[nodiscard]] double depth_step_at(const raster::Camera& camera, double distance);

}  // namespace kreda::scene
