#include "raster/rasterize_tile.hpp"

#include <algorithm>

#include "raster/depth.hpp"
#include "raster/platform.hpp"

namespace kreda::raster {

namespace {

/// Samples that are tested side by side. A constant, so that the compiler fills whole vector registers.
constexpr int kLanes = 16;

/// An edge function over one tile in 32 bits.
///
/// From one sample centre to the next E changes by a multiple of 256, so floor(E / 256) has the sign of E at every
/// centre and is all that the test needs. Within a tile it changes by less than 2^30 (63 samples in x and y times steps below
/// 2^23, see kGuardBand); a start value beyond +-2^30 can be cut there without changing any sign in the tile.
struct TileEdge {
    std::int32_t start = 0;   ///< at the tile's first sample; >= 0 means inside
    std::int32_t step_x = 0;  ///< to the next sample of the row
    std::int32_t step_y = 0;  ///< to the next row
};

TileEdge tile_edge(const ScreenVertex& a, const ScreenVertex& b, const TileArea& area) {
    const std::int64_t p_x = area.x * kSubpixels + kPixelCentre;
    const std::int64_t p_y = area.y * kSubpixels + kPixelCentre;
    const std::int64_t not_top_left = is_top_left(b.x - a.x, b.y - a.y) ? 0 : 1;
    const std::int64_t e = edge_function(a.x, a.y, b.x, b.y, p_x, p_y) - not_top_left;
    const std::int64_t limit = std::int64_t{1} << 30;
    const std::int64_t start = std::clamp(e >> kSubpixelBits, -limit, limit);
    return {static_cast<std::int32_t>(start), a.y - b.y, b.x - a.x};
}

/// Bounding box of a triangle in samples of the tile, the columns widened to whole groups of lanes.
struct TileBox { int x_first, x_end, y_first, y_last; };
TileBox tile_box(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c, const TileArea& area) {
    const auto first = [](std::int32_t min) { return (min + kPixelCentre - 1) >> kSubpixelBits; };
    const auto last = [](std::int32_t max) { return (max - kPixelCentre) >> kSubpixelBits; };
    TileBox box;
    box.x_first = std::max(first(std::min({a.x, b.x, c.x})) - area.x, 0) / kLanes * kLanes;
    box.x_end = std::min(last(std::max({a.x, b.x, c.x})) - area.x, area.width - 1) + 1;
    box.y_first = std::max(first(std::min({a.y, b.y, c.y})) - area.y, 0);
    box.y_last = std::min(last(std::max({a.y, b.y, c.y})) - area.y, area.height - 1);
    return box;
}

/// Edge tests and depth test for the samples of one triangle in one tile.
inline void draw_in_tile(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c, std::uint32_t id,
                         const TileArea& area, TileVisibility& tile) {
    const TileEdge ab = tile_edge(a, b, area);
    const TileEdge bc = tile_edge(b, c, area);
    const TileEdge ca = tile_edge(c, a, area);
    const DepthPlane plane = depth_plane(a, b, c, edge_function(a.x, a.y, b.x, b.y, c.x, c.y));
    const TileBox box = tile_box(a, b, c, area);
    for (int y = box.y_first; y <= box.y_last; ++y) {
        const float row_depth = depth_of_row(plane, area.y + y);
        for (int x = box.x_first; x < box.x_end; x += kLanes) {
            const std::int32_t e_ab = ab.start + ab.step_y * y + ab.step_x * x;
            const std::int32_t e_bc = bc.start + bc.step_y * y + bc.step_x * x;
            const std::int32_t e_ca = ca.start + ca.step_y * y + ca.step_x * x;
            float* depth = &tile.depth[y * kTileSide + x];
            std::uint32_t* triangle = &tile.triangle[y * kTileSide + x];
            for (int i = 0; i < kLanes; ++i) {
                const std::int32_t inside = (e_ab + ab.step_x * i) | (e_bc + bc.step_x * i) | (e_ca + ca.step_x * i);
                const float z = depth_at(plane, row_depth, area.x + x + i);
                const bool visible = (inside >= 0) & (z < depth[i]);
                depth[i] = visible ? z : depth[i];
                triangle[i] = visible ? id : triangle[i];
            }
        }
    }
}

/// All triangles of one chunk that touch the tile, in drawing order.
KREDA_BATCH_LOOP void draw_chunk_in_tile(const ScreenVertex* screen, const TriangleChunk& chunk,
                                         std::uint32_t first_id, const TileArea& area, TileVisibility& tile) {
    const std::uint32_t end = chunk.tile_begin[area.index + 1];
    for (std::uint32_t entry = chunk.tile_begin[area.index]; entry < end; ++entry) {
        const std::uint32_t index = chunk.tile_entries[entry];
        const ScreenTriangle& triangle = chunk.triangles[index];
        draw_in_tile(screen[triangle.vertex[0]], screen[triangle.vertex[1]], screen[triangle.vertex[2]],
                     first_id + index, area, tile);
    }
}

}  // namespace

TileArea tile_area(const TileGrid& grid, const Viewport& viewport, int index) {
    TileArea area;
    area.index = index;
    area.x = index % grid.columns * grid.tile_side;
    area.y = index / grid.columns * grid.tile_side;
    area.width = std::min(grid.tile_side, viewport.width - area.x);
    area.height = std::min(grid.tile_side, viewport.height - area.y);
    return area;
}

void rasterize_tile(const VertexStreams& streams, const TriangleSet& set, const TileArea& area,
                    TileVisibility& tile) {
    std::fill(std::begin(tile.depth), std::end(tile.depth), kClearDepth);
    std::fill(std::begin(tile.triangle), std::end(tile.triangle), kNoTriangle);
    for (std::size_t c = 0; c < set.chunks.size(); ++c) {
        const TriangleChunk& chunk = set.chunks[c];
        if (chunk.tile_begin[area.index] == chunk.tile_begin[area.index + 1]) continue;
        draw_chunk_in_tile(streams.screen.data(), chunk, triangle_id(c, 0), area, tile);
    }
}

VisibilityBuffer rasterize_tiled(const VertexStreams& streams, const TriangleSet& set, const Viewport& viewport) {
    VisibilityBuffer buffer(viewport.width, viewport.height);
    const int tile_count = set.grid.columns * set.grid.rows;
#pragma omp parallel for schedule(dynamic)
    for (int t = 0; t < tile_count; ++t) {
        TileVisibility tile;
        const TileArea area = tile_area(set.grid, viewport, t);
        rasterize_tile(streams, set, area, tile);
        for (int y = 0; y < area.height; ++y) {
            const std::size_t to = static_cast<std::size_t>(area.y + y) * viewport.width + area.x;
            std::copy_n(&tile.depth[y * kTileSide], area.width, &buffer.depth[to]);
            std::copy_n(&tile.triangle[y * kTileSide], area.width, &buffer.triangle[to]);
        }
    }
    return buffer;
}

}  // namespace kreda::raster
