#include "raster/rasterize_tile.hpp"

#include <algorithm>
#include <bit>

#include "raster/depth.hpp"
#include "raster/farthest_depth.hpp"
#include "raster/platform.hpp"
#include "raster/setup_lanes.hpp"
#include "raster/tile_triangle.hpp"

namespace kreda::raster {

namespace {

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

/// Ask memory for what fetch_corners() wants next, whose every look-up would wait for the one before it.
inline void ask_for_triangles(const TriangleChunk& chunk, std::uint32_t entry, std::uint32_t end) {
    for (; entry < end; ++entry) __builtin_prefetch(&chunk.triangles[chunk.tile_entries[entry]]);
}
inline void ask_for_corners(const ScreenVertex* screen, const TriangleChunk& chunk, std::uint32_t entry,
                            std::uint32_t end) {
    for (; entry < end; ++entry) {
        const ScreenTriangle& triangle = chunk.triangles[chunk.tile_entries[entry]];
        for (const std::uint32_t vertex : triangle.vertex) __builtin_prefetch(&screen[vertex]);
    }
}

inline void prepare_triangles(TileArea area, int lanes, SetupLanes& setup) {
    for (int i = 0; i < lanes; ++i) {
        const TileTriangle triangle = tile_triangle(setup.a.at(i), setup.b.at(i), setup.c.at(i), area);
        setup.set(i, triangle, covered_samples(triangle));
    }
}

/// What a sample shows from now on. A tile of depth alone has no room for the triangle.
inline void put(TileDepth& tile, int at, float z, std::uint32_t) {
    tile.depth[at] = z;
}
inline void put(TileVisibility& tile, int at, float z, std::uint32_t id) {
    tile.depth[at] = z;
    tile.triangle[at] = id;
}

/// The depth test without a branch. All is read in any case, so that clang vectorizes, too.
inline void put_nearest(TileDepth& tile, int at, bool inside, float z, std::uint32_t) {
    const float nearest = tile.depth[at];
    tile.depth[at] = (inside & (z < nearest)) ? z : nearest;
}
inline void put_nearest(TileVisibility& tile, int at, bool inside, float z, std::uint32_t id) {
    const float nearest = tile.depth[at];
    const std::uint32_t drawn = tile.triangle[at];
    const bool visible = inside & (z < nearest);
    tile.depth[at] = visible ? z : nearest;
    tile.triangle[at] = visible ? id : drawn;
}

/// Depth test for the covered samples of a triangle that lies within a block.
template <class Tile>
inline void draw_block(const SetupLanes& setup, int i, const TileArea& area, Tile& tile) {
    const DepthPlane plane = setup.depth_at(i);
    for (std::uint32_t rest = setup.covered[i]; rest != 0; rest &= rest - 1) {
        const int sample = std::countr_zero(rest);
        const int x = setup.x_first[i] + sample % kBlockSide;
        const int y = setup.y_first[i] + sample / kBlockSide;
        const float z = depth_at(plane, depth_of_row(plane, area.y + y), area.x + x);
        const int at = y * kTileSide + x;
        if (z < tile.depth[at]) put(tile, at, z, setup.id[i]);
    }
}

/// Samples that are tested side by side. A constant, so that the compiler fills whole vector registers.
constexpr int kSampleLanes = 16;

/// Sixteen samples side by side: a triangle's edges there, and what x says of its depth.
struct SampleLanes {
    alignas(64) std::int32_t ab[kSampleLanes];
    alignas(64) std::int32_t bc[kSampleLanes];
    alignas(64) std::int32_t ca[kSampleLanes];
    alignas(64) float column_depth[kSampleLanes];
};

inline SampleLanes samples_from(const TileTriangle& t, int x, int y, int x_of_tile) {
    SampleLanes samples;
    for (int i = 0; i < kSampleLanes; ++i) {
        samples.ab[i] = edge_at(t.edges.ab, x + i, y);
        samples.bc[i] = edge_at(t.edges.bc, x + i, y);
        samples.ca[i] = edge_at(t.edges.ca, x + i, y);
        samples.column_depth[i] = depth_of_column(t.depth, x_of_tile + x + i);
    }
    return samples;
}

/// Edge tests and depth test for some rows of sixteen columns, at least one, from the top down: from row to row each
/// edge takes one addition.
template <class Tile>
inline void draw_columns(const TileTriangle& t, int x, RowRange rows, std::uint32_t id, TileArea area, Tile& tile) {
    SampleLanes samples = samples_from(t, x, rows.first, area.x);
    const std::int32_t ab_down = t.edges.ab.step_y, bc_down = t.edges.bc.step_y, ca_down = t.edges.ca.step_y;
    float below = rows_below_anchor(t.depth, area.y + rows.first);
    for (int y = rows.first; y <= rows.last; ++y, below += 1.0f) {
        const float row_depth = depth_below_anchor(t.depth, below);
        const int first = y * kTileSide + x;
        for (int i = 0; i < kSampleLanes; ++i) {
            const bool inside = (samples.ab[i] | samples.bc[i] | samples.ca[i]) >= 0;
            put_nearest(tile, first + i, inside, depth_from(t.depth, row_depth, samples.column_depth[i]), id);
            samples.ab[i] += ab_down;
            samples.bc[i] += bc_down;
            samples.ca[i] += ca_down;
        }
    }
}

/// All rows of the box, sixteen columns after the other.
template <class Tile>
inline void draw_box(const TileTriangle& t, std::uint32_t id, TileArea area, Tile& tile) {
    const RowRange rows{t.box.y_first, t.box.y_last};
    for (int x = t.box.x_first & -kSampleLanes; x < t.box.x_end; x += kSampleLanes) {
        draw_columns(t, x, rows, id, area, tile);
    }
}

/// The box of a tall triangle: in each sixteen columns only the rows that the triangle reaches there.
template <class Tile>
inline void draw_reached_rows(const SetupLanes& setup, int i, TileArea area, Tile& tile) {
    const TileTriangle t = setup.at(i);
    for (int x = t.box.x_first & -kSampleLanes; x < t.box.x_end; x += kSampleLanes) {
        const RowRange rows = rows_of_columns(t, x, kSampleLanes);
        if (rows.first <= rows.last) draw_columns(t, x, rows, setup.id[i], area, tile);
    }
}
KREDA_BATCH_LOOP void draw_tall(const SetupLanes& setup, int i, TileArea area, TileDepth& tile) {
    draw_reached_rows(setup, i, area, tile);
}
KREDA_BATCH_LOOP void draw_tall(const SetupLanes& setup, int i, TileArea area, TileVisibility& tile) {
    draw_reached_rows(setup, i, area, tile);
}

/// Of fewer rows all are drawn sooner than it is asked which of them to draw.
constexpr int kTallRows = 24;

/// A triangle that fills a tile in which nothing is drawn yet: no sample needs a test, nor to be cleared before.
template <class Tile>
inline void fill_tile(const DepthPlane& plane, std::uint32_t id, TileArea area, Tile& tile) {
    alignas(64) float column_depth[kTileSide];
    for (int x = 0; x < kTileSide; ++x) column_depth[x] = depth_of_column(plane, area.x + x);
    for (int y = 0; y < area.height; ++y) {
        const float row_depth = depth_of_row(plane, area.y + y);
        for (int x = 0; x < kTileSide; ++x) {
            put(tile, y * kTileSide + x, depth_from(plane, row_depth, column_depth[x]), id);
        }
    }
}

/// What is known of a tile while it is drawn.
struct TileState {
    FarthestDepth farthest;
    bool has_begun = false;  ///< false: its samples hold anything
};

/// Draw a triangle that is larger than a block, unless all that is there is nearer.
template <class Tile>
inline void draw_large(const SetupLanes& setup, int i, const TileArea& area, FarthestDepth& farthest, Tile& tile) {
    if (farthest.hides(setup.z_min[i])) return;
    const int columns = setup.x_end[i] - setup.x_first[i], rows = setup.y_last[i] - setup.y_first[i] + 1;
    if (rows < kTallRows)
        draw_box(setup.at(i), setup.id[i], area, tile);
    else
        draw_tall(setup, i, area, tile);
    farthest.drawn += columns * rows;
    if (farthest.drawn >= kSamplesBetweenLooks) farthest = {farthest_depth(area, tile.depth), 0};
}

KREDA_BATCH_LOOP void clear(TileDepth& tile) {
    for (int i = 0; i < kTileSide * kTileSide; ++i) put(tile, i, kClearDepth, kNoTriangle);
}
KREDA_BATCH_LOOP void clear(TileVisibility& tile) {
    for (int i = 0; i < kTileSide * kTileSide; ++i) put(tile, i, kClearDepth, kNoTriangle);
}

/// Begin a tile with its first triangle. True if that is all to do with it.
template <class Tile>
inline bool begin_tile(const SetupLanes& setup, int i, const TileArea& area, TileState& state, Tile& tile) {
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
template <class Tile>
inline void draw_listed(const ScreenVertex* screen, const TriangleChunk& chunk, std::uint32_t first_id,
                        const TileArea& area, TileState& state, Tile& tile) {
    SetupLanes setup;
    const std::uint32_t end = chunk.tile_begin[area.index + 1];
    ask_for_triangles(chunk, chunk.tile_begin[area.index], end);
    for (std::uint32_t entry = chunk.tile_begin[area.index]; entry < end; entry += kScreenLanes) {
        const int count = static_cast<int>(std::min<std::uint32_t>(end - entry, kScreenLanes));
        fetch_corners(screen, chunk, entry, count, first_id, setup);
        ask_for_corners(screen, chunk, entry + count, std::min(end, entry + count + kScreenLanes));
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

KREDA_BATCH_LOOP void draw_chunk(const ScreenVertex* screen, const TriangleChunk& chunk, std::uint32_t first_id,
                                 const TileArea& area, TileState& state, TileDepth& tile) {
    draw_listed(screen, chunk, first_id, area, state, tile);
}
KREDA_BATCH_LOOP void draw_chunk(const ScreenVertex* screen, const TriangleChunk& chunk, std::uint32_t first_id,
                                 const TileArea& area, TileState& state, TileVisibility& tile) {
    draw_listed(screen, chunk, first_id, area, state, tile);
}

bool touches(const TriangleChunk& chunk, const TileArea& area) {
    return chunk.tile_begin[area.index] != chunk.tile_begin[area.index + 1];
}

template <class Tile>
void draw_chunks(const VertexStreams& streams, const TriangleSet& set, const TileArea& area, Tile& tile) {
    TileState state;
    for (std::size_t c = 0; c < set.chunks.size(); ++c) {
        const TriangleChunk& chunk = set.chunks[c];
        if (touches(chunk, area)) draw_chunk(streams.screen.data(), chunk, triangle_id(c, 0), area, state, tile);
    }
    if (!state.has_begun) clear(tile);
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
    draw_chunks(streams, set, area, tile);
}

void rasterize_tile(const VertexStreams& streams, const TriangleSet& set, const TileArea& area, TileDepth& tile) {
    draw_chunks(streams, set, area, tile);
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
