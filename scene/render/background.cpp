#include "scene/render/background.hpp"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "raster/fragments.hpp"
#include "raster/platform.hpp"

namespace kreda::scene {

namespace {

using raster::kTileSide;

constexpr int kRowsABatch = raster::kBatchCapacity / kTileSide;

KREDA_BATCH_LOOP void aim(const ViewRays& rays, int first_x, int y, int lanes, int first_lane,
                          raster::Channel3& direction) {
    const glm::vec3 row = rays.corner + (static_cast<float>(y) + 0.5f) * rays.down;
    const glm::vec3 right = rays.right;
    for (int i = 0; i < lanes; ++i) {
        direction.set(first_lane + i, row + (static_cast<float>(first_x + i) + 0.5f) * right);
    }
}

}  // namespace

ViewRays view_rays(const raster::Camera& camera, const raster::Viewport& viewport) {
    const raster::ViewAxes axes = view_axes(camera);
    if (camera.projection == raster::Projection::orthographic) return {glm::vec3(axes.forward), {}, {}};
    const double half_height = std::tan(0.5 * glm::radians(double{camera.vertical_fov_deg}));
    const double half_width = half_height * viewport.width / viewport.height;  // in double: aspect_of() rounds to float
    return {glm::vec3(axes.forward - half_width * axes.right + half_height * axes.up),
            glm::vec3(axes.right * (2.0 * half_width / viewport.width)),
            glm::vec3(axes.up * (-2.0 * half_height / viewport.height))};
}

void look_past_tile(const ViewRays& rays, const lighting::EnvironmentSetup& setup, const raster::TileArea& area,
                    lighting::EnvironmentChannels& channels, float* const planes[3]) {
    for (int y = 0; y < area.height; y += kRowsABatch) {
        const int rows = std::min(kRowsABatch, area.height - y);
        for (int row = 0; row < rows; ++row) {
            aim(rays, area.x, area.y + y + row, kTileSide, row * kTileSide, channels.direction);
        }
        look_at_environment(rows * kTileSide, setup, channels.direction, channels);
        std::copy_n(channels.prefiltered.x, rows * kTileSide, planes[0] + y * kTileSide);
        std::copy_n(channels.prefiltered.y, rows * kTileSide, planes[1] + y * kTileSide);
        std::copy_n(channels.prefiltered.z, rows * kTileSide, planes[2] + y * kTileSide);
    }
}

}  // namespace kreda::scene
