#include "raster/rasterize_tile.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "raster/depth.hpp"
#include "raster/farthest_depth.hpp"
#include "raster/platform.hpp"
#include "raster/sample_edges.hpp"
#include "raster/screen_lanes.hpp"

namespace kreda::raster {

namespace {

/// An edge function over one tile. Within it E / 256 changes by less than 2^30 (63 samples in x and y times steps below
/// 2^23, see kGuardBand); a start value beyond +-2^30 can be cut there without changing any sign in the tile.
inline SampleEdge tile_edge(const ScreenVertex& a, const ScreenVertex& b, const TileArea& area) {
    constexpr double kLimit = 1 << 30;
    const std::int32_t p_x = area.x * kSubpixels + kPixelCentre;
    const std::int32_t p_y = area.y * kSubpixels + kPixelCentre;
    const double least = least_inside(b.x - a.x, b.y - a.y);
    const double e = edge_function<double>(a.x, a.y, b.x, b.y, p_x, p_y) - least;
    const double start = std::floor(e * (1.0 / kSubpixels));
    const double not_below = start > -kLimit ? start : -kLimit;
    return {static_cast<std::int32_t>(not_below < kLimit ? not_below : kLimit), a.y - b.y, b.x - a.x};
}

/// Bounding box of a triangle in samples of the tile.
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
    return {std::max(x_first, 0), std::min(x_last, area.width - 1) + 1, std::max(y_first, 0),
            std::min(y_last, area.height - 1)};
}

/// What drawing a triangle in a tile needs to know of it.
struct TileTriangle {
    SampleEdges edges;
    DepthPlane depth;
    TileBox box;
};

/// In place of the samples that are covered: the box is larger than the block.
constexpr std::uint32_t kLargerThanBlock = 1u << (kBlockSide * kBlockSide);

/// Is the whole box outside of an edge? A large triangle's box is often in the tile when the triangle is not.
inline bool misses_box(const TileTriangle& t) {
    const auto most = [&](const SampleEdge& e) {
        return e.start + std::max(e.step_x * t.box.x_first, e.step_x * (t.box.x_end - 1)) +
               std::max(e.step_y * t.box.y_first, e.step_y * t.box.y_last);
    };
    return (most(t.edges.ab) | most(t.edges.bc) | most(t.edges.ca)) < 0;
}

/// The samples that a triangle covers of the block that begins with its box. kLargerThanBlock: it may cover others,
/// too.
inline std::uint32_t covered_samples(const TileTriangle& t) {
    const std::int32_t columns = t.box.x_end - t.box.x_first, rows = t.box.y_last - t.box.y_first + 1;
    const std::uint32_t covered = covered_in_block(t.edges, t.box.x_first, t.box.y_first);
    const std::uint32_t in_columns =
        0x1111u | (columns > 1 ? 0x2222u : 0u) | (columns > 2 ? 0x4444u : 0u) | (columns > 3 ? 0x8888u : 0u);
    const std::uint32_t in_rows =
        0x000fu | (rows > 1 ? 0x00f0u : 0u) | (rows > 2 ? 0x0f00u : 0u) | (rows > 3 ? 0xf000u : 0u);
    const bool larger = (columns > kBlockSide) | (rows > kBlockSide);
    const std::uint32_t covered_in_larger = misses_box(t) ? 0u : kLargerThanBlock;
    return larger ? covered_in_larger : covered & in_columns & in_rows;  // the tile may end within the block
}

inline TileTriangle tile_triangle(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c,
                                  const TileArea& area) {
    return {{tile_edge(a, b, area), tile_edge(b, c, area), tile_edge(c, a, area)},
            depth_plane(a, b, c, edge_function<double>(a.x, a.y, b.x, b.y, c.x, c.y)),
            tile_box(a, b, c, area)};
}

/// Triangles that are prepared side by side, and what comes out: one array a number, a lane a triangle.
struct EdgeLanes {
    std::int32_t start[kScreenLanes], step_x[kScreenLanes], step_y[kScreenLanes];

    void set(int i, const SampleEdge& e) {
        start[i] = e.start;
        step_x[i] = e.step_x;
        step_y[i] = e.step_y;
    }
    [[nodiscard]] SampleEdge at(int i) const {
        return {start[i], step_x[i], step_y[i]};
    }
};

struct SetupLanes {
    ScreenLanes a, b, c;
    std::uint32_t id[kScreenLanes];
    EdgeLanes ab, bc, ca;
    float dz_dx[kScreenLanes], dz_dy[kScreenLanes], z_min[kScreenLanes], z_max[kScreenLanes];
    std::int32_t x_first[kScreenLanes], x_end[kScreenLanes], y_first[kScreenLanes], y_last[kScreenLanes];
    std::uint32_t covered[kScreenLanes];

    void set(int i, const TileTriangle& t, std::uint32_t samples) {
        covered[i] = samples;
        ab.set(i, t.edges.ab);
        bc.set(i, t.edges.bc);
        ca.set(i, t.edges.ca);
        dz_dx[i] = t.depth.dz_dx;
        dz_dy[i] = t.depth.dz_dy;
        z_min[i] = t.depth.z_min;
        z_max[i] = t.depth.z_max;
        x_first[i] = t.box.x_first;
        x_end[i] = t.box.x_end;
        y_first[i] = t.box.y_first;
        y_last[i] = t.box.y_last;
    }
    [[nodiscard]] DepthPlane depth_at(int i) const {
        return {a.x[i], a.y[i], a.z[i], dz_dx[i], dz_dy[i], z_min[i], z_max[i]};
    }
    [[nodiscard]] TileTriangle at(int i) const {
        return {{ab.at(i), bc.at(i), ca.at(i)}, depth_at(i), {x_first[i], x_end[i], y_first[i], y_last[i]}};
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

inline void prepare_triangles(TileArea area, int lanes, SetupLanes& setup) {
    for (int i = 0; i < lanes; ++i) {
        const TileTriangle triangle = tile_triangle(setup.a.at(i), setup.b.at(i), setup.c.at(i), area);
        setup.set(i, triangle, covered_samples(triangle));
    }
}

/// Depth test for the covered samples of a triangle that lies within a block.
inline void draw_block(const SetupLanes& setup, int i, const TileArea& area, TileVisibility& tile) {
    const DepthPlane plane = setup.depth_at(i);
    for (std::uint32_t rest = setup.covered[i]; rest != 0; rest &= rest - 1) {
        const int sample = std::countr_zero(rest);
        const int x = setup.x_first[i] + sample % kBlockSide;
        const int y = setup.y_first[i] + sample / kBlockSide;
        const float z = depth_at(plane, depth_of_row(plane, area.y + y), area.x + x);
        const int at = y * kTileSide + x;
        if (z < tile.depth[at]) {
            tile.depth[at] = z;
            tile.triangle[at] = setup.id[i];
        }
    }
}

/// Sixteen columns of samples: what x says of a triangle's edges and depth there.
struct ColumnLanes {
    alignas(64) std::int32_t ab[kSampleLanes];
    alignas(64) std::int32_t bc[kSampleLanes];
    alignas(64) std::int32_t ca[kSampleLanes];
    alignas(64) float depth[kSampleLanes];
};

inline ColumnLanes columns_from(const TileTriangle& t, int x, int x_of_tile) {
    ColumnLanes columns;
    for (int i = 0; i < kSampleLanes; ++i) {
        columns.ab[i] = edge_at(t.edges.ab, x + i, 0);
        columns.bc[i] = edge_at(t.edges.bc, x + i, 0);
        columns.ca[i] = edge_at(t.edges.ca, x + i, 0);
        columns.depth[i] = depth_of_column(t.depth, x_of_tile + x + i);
    }
    return columns;
}

/// Edge tests and depth test for the samples of one triangle in one tile: sixteen columns from the top down, then the
/// next sixteen, so that what x says is computed once for all rows.
inline void draw_columns(const TileTriangle& t, std::uint32_t id, TileArea area, TileVisibility& tile) {
    for (int x = t.box.x_first & -kSampleLanes; x < t.box.x_end; x += kSampleLanes) {
        const ColumnLanes columns = columns_from(t, x, area.x);
        for (int y = t.box.y_first; y <= t.box.y_last; ++y) {
            const float row_depth = depth_of_row(t.depth, area.y + y);
            const std::int32_t ab = t.edges.ab.step_y * y, bc = t.edges.bc.step_y * y, ca = t.edges.ca.step_y * y;
            float* depth = &tile.depth[y * kTileSide + x];
            std::uint32_t* triangle = &tile.triangle[y * kTileSide + x];
            for (int i = 0; i < kSampleLanes; ++i) {
                const std::int32_t inside = (columns.ab[i] + ab) | (columns.bc[i] + bc) | (columns.ca[i] + ca);
                const float z = depth_from(t.depth, row_depth, columns.depth[i]);
                const float nearest = depth[i];  // both are read in any case, so that clang vectorizes, too
                const std::uint32_t drawn = triangle[i];
                const bool visible = (inside >= 0) & (z < nearest);
                depth[i] = visible ? z : nearest;
                triangle[i] = visible ? id : drawn;
            }
        }
    }
}

/// Draw a triangle that is larger than a block, unless all that is there is nearer.
inline void draw_large(const SetupLanes& setup, int i, const TileArea& area, FarthestDepth& farthest,
                       TileVisibility& tile) {
    if (farthest.hides(setup.z_min[i])) return;
    const TileTriangle t = setup.at(i);
    draw_columns(t, setup.id[i], area, tile);
    farthest.drawn += (t.box.x_end - t.box.x_first) * (t.box.y_last - t.box.y_first + 1);
    if (farthest.drawn >= kSamplesBetweenLooks) farthest = {farthest_depth(area, tile), 0};
}

KREDA_BATCH_LOOP void clear(TileVisibility& tile) {
    for (int i = 0; i < kTileSide * kTileSide; ++i) {
        tile.depth[i] = kClearDepth;
        tile.triangle[i] = kNoTriangle;
    }
}

/// All triangles of one chunk that touch the tile, in drawing order.
KREDA_BATCH_LOOP void draw_chunk_in_tile(const ScreenVertex* screen, const TriangleChunk& chunk, std::uint32_t first_id,
                                         const TileArea& area, FarthestDepth& farthest, TileVisibility& tile) {
    SetupLanes setup;
    const std::uint32_t end = chunk.tile_begin[area.index + 1];
    for (std::uint32_t entry = chunk.tile_begin[area.index]; entry < end; entry += kScreenLanes) {
        const int count = static_cast<int>(std::min<std::uint32_t>(end - entry, kScreenLanes));
        fetch_corners(screen, chunk, entry, count, first_id, setup);
        prepare_triangles(area, lanes_for(count), setup);
        for (int i = 0; i < count; ++i) {
            if (setup.covered[i] != kLargerThanBlock)
                draw_block(setup, i, area, tile);
            else
                draw_large(setup, i, area, farthest, tile);
        }
    }
}

bool touches(const TriangleChunk& chunk, const TileArea& area) {
    return chunk.tile_begin[area.index] != chunk.tile_begin[area.index + 1];
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

bool any_triangle_touches(const TriangleSet& set, const TileArea& area) {
    return std::any_of(set.chunks.begin(), set.chunks.end(),
                       [&](const TriangleChunk& chunk) { return touches(chunk, area); });
}

void rasterize_tile(const VertexStreams& streams, const TriangleSet& set, const TileArea& area, TileVisibility& tile) {
    clear(tile);
    FarthestDepth farthest;
    for (std::size_t c = 0; c < set.chunks.size(); ++c) {
        const TriangleChunk& chunk = set.chunks[c];
        if (!touches(chunk, area)) continue;
        draw_chunk_in_tile(streams.screen.data(), chunk, triangle_id(c, 0), area, farthest, tile);
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
