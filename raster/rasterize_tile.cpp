#include "raster/rasterize_tile.hpp"

#include <algorithm>
#include <bit>

#include "raster/depth.hpp"
#include "raster/farthest_depth.hpp"
#include "raster/platform.hpp"
#include "raster/screen_lanes.hpp"
#include "raster/tile_triangle.hpp"

namespace kreda::raster {

namespace {

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

/// Edge tests and depth test for some rows of sixteen columns, from the top down: what x says is computed once for all.
inline void draw_columns(const TileTriangle& t, int x, RowRange rows, std::uint32_t id, TileArea area,
                         TileVisibility& tile) {
    const ColumnLanes columns = columns_from(t, x, area.x);
    for (int y = rows.first; y <= rows.last; ++y) {
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

/// All rows of the box, sixteen columns after the other.
inline void draw_box(const TileTriangle& t, std::uint32_t id, TileArea area, TileVisibility& tile) {
    const RowRange rows{t.box.y_first, t.box.y_last};
    for (int x = t.box.x_first & -kSampleLanes; x < t.box.x_end; x += kSampleLanes) {
        draw_columns(t, x, rows, id, area, tile);
    }
}

/// The box of a tall triangle: in each sixteen columns only the rows that the triangle reaches there.
KREDA_BATCH_LOOP void draw_tall(const SetupLanes& setup, int i, TileArea area, TileVisibility& tile) {
    const TileTriangle t = setup.at(i);
    for (int x = t.box.x_first & -kSampleLanes; x < t.box.x_end; x += kSampleLanes) {
        draw_columns(t, x, rows_of_columns(t, x, kSampleLanes), setup.id[i], area, tile);
    }
}

/// Of fewer rows all are drawn sooner than it is asked which of them to draw.
constexpr int kTallRows = 24;

/// A triangle that fills a tile in which nothing is drawn yet: no sample needs a test, nor to be cleared before.
inline void fill_tile(const DepthPlane& plane, std::uint32_t id, TileArea area, TileVisibility& tile) {
    alignas(64) float column_depth[kTileSide];
    for (int x = 0; x < kTileSide; ++x) column_depth[x] = depth_of_column(plane, area.x + x);
    for (int y = 0; y < area.height; ++y) {
        const float row_depth = depth_of_row(plane, area.y + y);
        float* depth = &tile.depth[y * kTileSide];
        std::uint32_t* triangle = &tile.triangle[y * kTileSide];
        for (int x = 0; x < kTileSide; ++x) {
            depth[x] = depth_from(plane, row_depth, column_depth[x]);
            triangle[x] = id;
        }
    }
}

/// What is known of a tile while it is drawn.
struct TileState {
    FarthestDepth farthest;
    bool has_begun = false;  ///< false: its samples hold anything
};

/// Draw a triangle that is larger than a block, unless all that is there is nearer.
inline void draw_large(const SetupLanes& setup, int i, const TileArea& area, FarthestDepth& farthest,
                       TileVisibility& tile) {
    if (farthest.hides(setup.z_min[i])) return;
    const int columns = setup.x_end[i] - setup.x_first[i], rows = setup.y_last[i] - setup.y_first[i] + 1;
    if (rows < kTallRows)
        draw_box(setup.at(i), setup.id[i], area, tile);
    else
        draw_tall(setup, i, area, tile);
    farthest.drawn += columns * rows;
    if (farthest.drawn >= kSamplesBetweenLooks) farthest = {farthest_depth(area, tile), 0};
}

KREDA_BATCH_LOOP void clear(TileVisibility& tile) {
    for (int i = 0; i < kTileSide * kTileSide; ++i) {
        tile.depth[i] = kClearDepth;
        tile.triangle[i] = kNoTriangle;
    }
}

/// Begin a tile with its first triangle. True if that is all to do with it.
inline bool begin_tile(const SetupLanes& setup, int i, const TileArea& area, TileState& state, TileVisibility& tile) {
    state.has_begun = true;
    const bool fills = setup.covered[i] == kLargerThanBlock && fills_tile(setup.at(i), area);
    if (!fills) {
        clear(tile);
        return false;
    }
    fill_tile(setup.depth_at(i), setup.id[i], area, tile);
    state.farthest = {setup.z_max[i], 0};
    return true;
}

/// All triangles of one chunk that touch the tile, in drawing order.
KREDA_BATCH_LOOP void draw_chunk_in_tile(const ScreenVertex* screen, const TriangleChunk& chunk, std::uint32_t first_id,
                                         const TileArea& area, TileState& state, TileVisibility& tile) {
    SetupLanes setup;
    const std::uint32_t end = chunk.tile_begin[area.index + 1];
    for (std::uint32_t entry = chunk.tile_begin[area.index]; entry < end; entry += kScreenLanes) {
        const int count = static_cast<int>(std::min<std::uint32_t>(end - entry, kScreenLanes));
        fetch_corners(screen, chunk, entry, count, first_id, setup);
        prepare_triangles(area, lanes_for(count), setup);
        for (int i = 0; i < count; ++i) {
            if (setup.covered[i] == 0) continue;
            if (!state.has_begun && begin_tile(setup, i, area, state, tile)) continue;
            if (setup.covered[i] != kLargerThanBlock)
                draw_block(setup, i, area, tile);
            else
                draw_large(setup, i, area, state.farthest, tile);
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
    TileState state;
    for (std::size_t c = 0; c < set.chunks.size(); ++c) {
        const TriangleChunk& chunk = set.chunks[c];
        if (!touches(chunk, area)) continue;
        draw_chunk_in_tile(streams.screen.data(), chunk, triangle_id(c, 0), area, state, tile);
    }
    if (!state.has_begun) clear(tile);
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
