#include "scene/render/visibility_check.hpp"

#include <bit>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "raster/rasterize_reference.hpp"
#include "raster/rasterize_tile.hpp"
#include "scene/render/render.hpp"

namespace kreda::scene {

void check_visibility_if_asked(const Frame& frame) {
    if (std::getenv("KREDA_CHECK_VISIBILITY") == nullptr) return;
    const RenderBuffers& buffers = frame.buffers;
    const raster::Viewport& viewport = frame.plan.viewport;
    const raster::VisibilityBuffer fast = rasterize_tiled(buffers.streams, buffers.triangles, viewport);
    const raster::VisibilityBuffer lecture = rasterize_reference(buffers.streams, buffers.triangles, viewport);
    for (std::size_t i = 0; i < fast.depth.size(); ++i) {
        const bool same_depth =
            std::bit_cast<std::uint32_t>(fast.depth[i]) == std::bit_cast<std::uint32_t>(lecture.depth[i]);
        if (same_depth && fast.triangle[i] == lecture.triangle[i]) continue;
        const std::size_t width = static_cast<std::size_t>(viewport.width);
        throw std::logic_error("the tiled rasterizer differs from the reference at sample " +
                               std::to_string(i % width) + "," + std::to_string(i / width));
    }
    std::printf("visibility: %zu samples, the same as the reference\n", fast.depth.size());
}

}  // namespace kreda::scene
