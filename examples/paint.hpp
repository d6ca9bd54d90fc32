// A picture of any function of the surface: one mesh, one camera, a colour for every sample that is seen.
#pragma once

#include <functional>

#include "examples/draw.hpp"
#include "raster/camera.hpp"
#include "raster/mesh.hpp"

namespace kreda::examples {

/// What a sample sees.
struct SurfacePoint {
    glm::vec3 position;  ///< world space
    glm::vec3 n;         ///< unit normal
    glm::vec3 v;         ///< unit, to the viewer
};

using SurfaceColor = std::function<glm::vec3(const SurfacePoint&)>;

/// Calls visit(x, y, point) for each of size.x x size.y samples that sees the mesh, which stands as it is in the world.
void for_each_surface_point(const raster::Mesh& mesh, const raster::Camera& camera, glm::ivec2 size,
                            const std::function<void(int, int, const SurfacePoint&)>& visit);

/// The mesh in these colours on a background, each pixel the mean of samples x samples.
[[nodiscard]] Image paint(const raster::Mesh& mesh, const raster::Camera& camera, glm::ivec2 size, int samples,
                          const glm::vec3& background, const SurfaceColor& color);

}  // namespace kreda::examples
