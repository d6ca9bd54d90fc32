// All visible samples of a frame at once: what the methods that work frame by frame look at.
#pragma once

#include <cstddef>

#include "raster/aligned_vector.hpp"
#include "raster/triangle_setup.hpp"
#include "shadows/shadow.hpp"

namespace kreda::shadows {

/// The memory of VisibleSamples, and which triangle is seen.
struct VisibleSampleMemory {
    raster::Viewport viewport;                      ///< the sample grid
    glm::mat4 clip_from_world{1.0f};                ///< of the camera
    raster::AlignedVector<float> depth;             ///< raster::kClearDepth where nothing is seen
    raster::AlignedVector<glm::vec3> position;      ///< world space; (0, 0, 0) where nothing is seen
    raster::AlignedVector<std::uint32_t> triangle;  ///< raster::triangle_id() in the set, or raster::kNoTriangle

    /// The samples as the methods read them.
    [[nodiscard]] VisibleSamples samples() const {
        return {viewport, clip_from_world, depth, position};
    }
};

/// Bytes that find_visible takes while it runs, a thread.
[[nodiscard]] std::size_t bytes_to_find_visible();

/// Draw the triangles of a set, tile by tile, and interpolate the position of every visible sample as shading does: the
/// streams hold positions, and `frame` keeps its memory from call to call.
void find_visible(const raster::VertexStreams& streams, const raster::TriangleSet& set,
                  raster::AttributeInterpolation interpolation, const raster::Viewport& viewport,
                  const glm::mat4& clip_from_world, VisibleSampleMemory& frame);

}  // namespace kreda::shadows
