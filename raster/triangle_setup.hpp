// Triangle setup: which triangles can be seen at all, clipped where they must be, sorted into the tiles they touch.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "raster/aligned_vector.hpp"
#include "raster/judge_triangle.hpp"
#include "raster/tile_grid.hpp"
#include "raster/vertex_stage.hpp"

namespace kreda::raster {

/// A triangle on the screen: three vertices in the streams, clockwise with y down, so that its area is positive.
struct ScreenTriangle {
    std::array<std::uint32_t, 3> vertex{};  ///< indices into the streams
    std::uint32_t source = 0;               ///< number of the scene's triangle it came from, counted over all instances
    std::uint32_t material : 31 = 0;        ///< index into the frame's materials
    std::uint32_t behind : 1 = 0;  ///< 1: the camera sees its back, its corners are clockwise seen from the camera
};

/// Triangles that were left out, and why.
struct TriangleCounts {
    std::uint64_t input = 0;       ///< all that the meshes have
    std::uint64_t drawn = 0;       ///< triangles that reach the tiles; one that was clipped may become several
    std::uint64_t culled = 0;      ///< facing the wrong way
    std::uint64_t outside = 0;     ///< outside the view, or between the sample centres
    std::uint64_t degenerate = 0;  ///< no area after the snap to 1/256 sample
    std::uint64_t non_finite = 0;  ///< a corner is NaN or infinite
    std::uint64_t clipped = 0;     ///< went through the clipper
};

/// Triangles are set up in chunks of this many of one mesh instance, whatever their parts and the number of threads, so
/// that the order never changes.
inline constexpr std::uint32_t kTrianglesPerChunk = 4096;

/// A triangle's number holds its chunk and its place in it; clipping makes at most 14 triangles out of one.
inline constexpr int kChunkShift = 16;

/// As many chunks as a triangle's number can name; the last number is no triangle.
inline constexpr std::uint32_t kMostChunks = (1u << (32 - kChunkShift)) - 1;

/// Bytes that a thread needs while it sets up the triangles of a mesh that has so many; where some are clipped, twice.
[[nodiscard]] std::size_t bytes_to_set_up(std::size_t triangles);

/// The set-up triangles of one chunk, in the order in which they are drawn, and for each tile those that touch it.
struct TriangleChunk {
    AlignedVector<ScreenTriangle> triangles;    ///< those that are drawn
    std::vector<std::uint32_t> tile_begin;      ///< tile t owns tile_entries[tile_begin[t] .. tile_begin[t+1])
    AlignedVector<std::uint16_t> tile_entries;  ///< indices into triangles, in drawing order
    TriangleCounts counts;                      ///< of this chunk
    std::uint32_t instance = 0;                 ///< all triangles of a chunk belong to one mesh instance
    std::uint32_t first_source = 0;             ///< number of that instance's first triangle over all instances
};

/// All triangles of a frame. Reused from frame to frame, so that memory is asked for once.
struct TriangleSet {
    TileGrid grid;                      ///< that the tiles of all chunks belong to
    std::vector<TriangleChunk> chunks;  ///< in drawing order

    /// The triangle with that number.
    [[nodiscard]] const ScreenTriangle& triangle(std::uint32_t id) const {
        return chunks[id >> kChunkShift].triangles[id & ((1u << kChunkShift) - 1)];
    }
};

/// Number of a triangle in a TriangleSet; later ones are drawn later within a chunk.
[[nodiscard]] inline std::uint32_t triangle_id(std::size_t chunk, std::size_t index) {
    return static_cast<std::uint32_t>(chunk << kChunkShift | index);
}

/// The corner from which a fan of triangles covers a clipped polygon without folding over. It is convex before the snap
/// to 1/256 sample; a sliver may come out of it slightly concave, and then a fan from the wrong corner covers samples
/// twice.
[[nodiscard]] int fan_apex(const ScreenVertex* corner, int count);

/// Cull, clip and bin the triangles of all instances. New vertices made by the clipper are appended to the streams,
/// with every attribute that the streams hold.
TriangleCounts setup_triangles(const std::vector<MeshInstance>& instances, const glm::mat4& clip_from_world,
                               const Viewport& viewport, CullMode cull, int samples, VertexStreams& streams,
                               TriangleSet& set);

}  // namespace kreda::raster
