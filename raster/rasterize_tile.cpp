#include "raster/rasterize_tile.hpp"

#include <algorithm>
#include <cmath>

#include "raster/depth.hpp"
#include "raster/platform.hpp"
#include "raster/screen_lanes.hpp"

namespace kreda::raster {

namespace {

/// Samples that are tested side by side. A constant, so that the compiler fills whole vector registers.
constexpr int kLanes = 16;

/// An edge function over one tile in 32 bits.
///
/// From one sample centre to the next E changes by a multiple of 256, so floor(E / 256) has the sign of E at every
/// centre and is all that the test needs. Within a tile it changes by less than 2^30 (63 samples in x and y times steps
/// below 2^23, see kGuardBand); a start value beyond +-2^30 can be cut there without changing any sign in the tile.
struct TileEdge {
    std::int32_t start = 0;   ///< at the tile's first sample; >= 0 means inside
    std::int32_t step_x = 0;  ///< to the next sample of the row
    std::int32_t step_y = 0;  ///< to the next row
};

inline TileEdge tile_edge(const ScreenVertex& a, const ScreenVertex& b, const TileArea& area) {
    constexpr double kLimit = 1 << 30;
    const std::int32_t p_x = area.x * kSubpixels + kPixelCentre;
    const std::int32_t p_y = area.y * kSubpixels + kPixelCentre;
    const double not_top_left = is_top_left(b.x - a.x, b.y - a.y) ? 0.0 : 1.0;
    const double e = edge_function<double>(a.x, a.y, b.x, b.y, p_x, p_y) - not_top_left;
    const double start = std::floor(e * (1.0 / kSubpixels));
    const double not_below = start > -kLimit ? start : -kLimit;
    return {static_cast<std::int32_t>(not_below < kLimit ? not_below : kLimit), a.y - b.y, b.x - a.x};
}

/// Bounding box of a triangle in samples of the tile, the columns widened to whole groups of lanes.
struct TileBox {
    std::int32_t x_first = 0, x_end = 0, y_first = 0, y_last = 0;
};

inline TileBox tile_box(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c, const TileArea& area) {
    const auto first = [](std::int32_t min) { return (min + kPixelCentre - 1) >> kSubpixelBits; };
    const auto last = [](std::int32_t max) { return (max - kPixelCentre) >> kSubpixelBits; };
    const std::int32_t x_first = first(std::min(std::min(a.x, b.x), c.x)) - area.x;
    const std::int32_t y_first = first(std::min(std::min(a.y, b.y), c.y)) - area.y;
    const std::int32_t x_last = last(std::max(std::max(a.x, b.x), c.x)) - area.x;
    const std::int32_t y_last = last(std::max(std::max(a.y, b.y), c.y)) - area.y;
    return {std::max(x_first, 0) & -kLanes, std::min(x_last, area.width - 1) + 1, std::max(y_first, 0),
            std::min(y_last, area.height - 1)};
}

/// What drawing a triangle in a tile needs to know of it.
struct TileTriangle {
    TileEdge ab, bc, ca;
    DepthPlane depth;
    TileBox box;
};

inline TileTriangle tile_triangle(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c,
                                  const TileArea& area) {
    return {tile_edge(a, b, area), tile_edge(b, c, area), tile_edge(c, a, area),
            depth_plane(a, b, c, edge_function<double>(a.x, a.y, b.x, b.y, c.x, c.y)), tile_box(a, b, c, area)};
}

/// Triangles that are prepared side by side, and what comes out: one array a number, a lane a triangle.
struct EdgeLanes {
    std::int32_t start[kScreenLanes], step_x[kScreenLanes], step_y[kScreenLanes];

    void set(int i, const TileEdge& e) {
        start[i] = e.start;
        step_x[i] = e.step_x;
        step_y[i] = e.step_y;
    }
    [[nodiscard]] TileEdge at(int i) const {
        return {start[i], step_x[i], step_y[i]};
    }
};

struct SetupLanes {
    ScreenLanes a, b, c;
    std::uint32_t id[kScreenLanes];
    EdgeLanes ab, bc, ca;
    float dz_dx[kScreenLanes], dz_dy[kScreenLanes], z_min[kScreenLanes], z_max[kScreenLanes];
    std::int32_t x_first[kScreenLanes], x_end[kScreenLanes], y_first[kScreenLanes], y_last[kScreenLanes];

    void set(int i, const TileTriangle& t) {
        ab.set(i, t.ab);
        bc.set(i, t.bc);
        ca.set(i, t.ca);
        dz_dx[i] = t.depth.dz_dx;
        dz_dy[i] = t.depth.dz_dy;
        z_min[i] = t.depth.z_min;
        z_max[i] = t.depth.z_max;
        x_first[i] = t.box.x_first;
        x_end[i] = t.box.x_end;
        y_first[i] = t.box.y_first;
        y_last[i] = t.box.y_last;
    }
    [[nodiscard]] TileTriangle at(int i) const {
        const DepthPlane depth{a.x[i], a.y[i], a.z[i], dz_dx[i], dz_dy[i], z_min[i], z_max[i]};
        return {ab.at(i), bc.at(i), ca.at(i), depth, {x_first[i], x_end[i], y_first[i], y_last[i]}};
    }
};

/// Fetch the corners of `count` triangles; the lanes behind the last repeat it.
inline void fetch_corners(const ScreenVertex* screen, const TriangleChunk& chunk, std::uint32_t first_entry, int count,
                          std::uint32_t first_id, SetupLanes& setup) {
    const int lanes = lanes_for(count);
    for (int i = 0; i < lanes; ++i) {  // not vectorized: each triangle lies somewhere else
        const std::uint32_t index = chunk.tile_entries[first_entry + std::min(i, count - 1)];
        const ScreenTriangle& triangle = chunk.triangles[index];
        setup.id[i] = first_id + index;
        setup.a.set(i, screen[triangle.vertex[0]]);
        setup.b.set(i, screen[triangle.vertex[1]]);
        setup.c.set(i, screen[triangle.vertex[2]]);
    }
}

inline void prepare_triangles(const TileArea& tile_area, int lanes, SetupLanes& setup) {
    const TileArea area = tile_area;
    for (int i = 0; i < lanes; ++i) setup.set(i, tile_triangle(setup.a.at(i), setup.b.at(i), setup.c.at(i), area));
}

/// Edge tests and depth test for the samples of one triangle in one tile.
inline void draw_in_tile(const TileTriangle& t, std::uint32_t id, const TileArea& area, TileVisibility& tile) {
    for (int y = t.box.y_first; y <= t.box.y_last; ++y) {
        const float row_depth = depth_of_row(t.depth, area.y + y);
        for (int x = t.box.x_first; x < t.box.x_end; x += kLanes) {
            const std::int32_t e_ab = t.ab.start + t.ab.step_y * y + t.ab.step_x * x;
            const std::int32_t e_bc = t.bc.start + t.bc.step_y * y + t.bc.step_x * x;
            const std::int32_t e_ca = t.ca.start + t.ca.step_y * y + t.ca.step_x * x;
            float* depth = &tile.depth[y * kTileSide + x];
            std::uint32_t* triangle = &tile.triangle[y * kTileSide + x];
            for (int i = 0; i < kLanes; ++i) {
                const std::int32_t inside =
                    (e_ab + t.ab.step_x * i) | (e_bc + t.bc.step_x * i) | (e_ca + t.ca.step_x * i);
                const float z = depth_at(t.depth, row_depth, area.x + x + i);
                const bool visible = (inside >= 0) & (z < depth[i]);
                depth[i] = visible ? z : depth[i];
                triangle[i] = visible ? id : triangle[i];
            }
        }
    }
}

/// All triangles of one chunk that touch the tile, in drawing order.
KREDA_BATCH_LOOP void draw_chunk_in_tile(const ScreenVertex* screen, const TriangleChunk& chunk, std::uint32_t first_id,
                                         const TileArea& area, TileVisibility& tile) {
    SetupLanes setup;
    const std::uint32_t end = chunk.tile_begin[area.index + 1];
    for (std::uint32_t entry = chunk.tile_begin[area.index]; entry < end; entry += kScreenLanes) {
        const int count = static_cast<int>(std::min<std::uint32_t>(end - entry, kScreenLanes));
        fetch_corners(screen, chunk, entry, count, first_id, setup);
        prepare_triangles(area, lanes_for(count), setup);
        for (int i = 0; i < count; ++i) draw_in_tile(setup.at(i), setup.id[i], area, tile);
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

void rasterize_tile(const VertexStreams& streams, const TriangleSet& set, const TileArea& area, TileVisibility& tile) {
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
