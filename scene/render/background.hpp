// What is seen where nothing was drawn: the environment.
#pragma once

#include <glm/mat4x4.hpp>

#include "lighting/batch/channels.hpp"
#include "lighting/batch/environment_passes.hpp"
#include "raster/camera.hpp"
#include "raster/rasterize_tile.hpp"
#include "raster/screen.hpp"

namespace kreda::scene {

/// Directions through the samples of the picture, affine in their numbers:  d = corner + right x + down y,  for the
/// centre of sample (x, y). World space, not unit.
struct ViewRays {
    glm::vec3 corner{0.0f}, right{0.0f}, down{0.0f};
};

[[nodiscard]] ViewRays view_rays(const raster::Camera& camera, const raster::Viewport& viewport);

/// The environment's radiance at every sample of a tile, row by row, kTileSide values a row, into three planes.
void look_past_tile(const ViewRays& rays, const lighting::EnvironmentSetup& setup, const raster::TileArea& area,
                    lighting::EnvironmentChannels& channels, float* const planes[3]);

}  // namespace kreda::scene
