// The scene's objects as the rasterizer takes them.
#pragma once

#include <vector>

#include "raster/vertex_stage.hpp"
#include "scene/scene.hpp"

namespace kreda::scene {

/// One instance an object, in their order. They point to the scene's meshes.
[[nodiscard]] std::vector<raster::MeshInstance> make_instances(const Scene& scene);

}  // namespace kreda::scene
