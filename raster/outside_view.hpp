// Whether an object as a whole lies beyond the view, so that its triangles need not be looked at one by one.
#pragma once

#include <glm/mat4x4.hpp>

#include "raster/screen.hpp"
#include "raster/vertex_stage.hpp"

namespace kreda::raster {

/// Does the box around the mesh lie clearly beyond the near plane, the far plane or one side of the guard band? Then
/// nothing is left of any of its triangles, as clip_triangle() would find. false where a coordinate is not finite, and
/// where it is not certain.
[[nodiscard]] bool lies_outside(const MeshInstance& instance, const glm::mat4& clip_from_world,
                                const Viewport& viewport);

}  // namespace kreda::raster
