// A triangle as one tile sees it: edges, depth and box at the tile's samples, and what they say before any sample is
// asked.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "raster/depth.hpp"
#include "raster/rasterize_tile.hpp"
#include "raster/sample_edges.hpp"

namespace kreda::raster {

/// An edge function over one tile. Within it E / 256 changes by less than 2^30 (63 samples in x and y times steps below
/// 2^23, see kGuardBand); a start value beyond +-2^30 can be cut there without changing any sign in the tile.
inline SampleEdge tile_edge(const ScreenVertex& a, const ScreenVertex& b, const TileArea& area) {
    constexpr double kLimit = 1 << 30;
    const std::int32_t p_x = centre_of(area.x);
    const std::int32_t p_y = centre_of(area.y);
    const double least = least_inside(b.x - a.x, b.y - a.y);
    const double e = edge_function<double>(a.x, a.y, b.x, b.y, p_x, p_y) - least;
    const double start = std::floor(e * (1.0 / kSubpixels));
    const double not_below = start > -kLimit ? start : -kLimit;
    return {static_cast<std::int32_t>(not_below < kLimit ? not_below : kLimit), a.y - b.y, b.x - a.x};
}

/// Bounding box of a triangle in samples of the tile.
struct TileBox {
    std::int32_t x_first = 0, x_end = 0;   ///< columns; the end is not included
    std::int32_t y_first = 0, y_last = 0;  ///< rows, both included
};

/// The box of a triangle, cut at the tile's border.
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
    SampleEdges edges;  ///< at the tile's first sample
    DepthPlane depth;   ///< window depth
    TileBox box;        ///< of the samples it may cover
};

/// In place of the samples that are covered: the box is larger than the block.
inline constexpr std::uint32_t kLargerThanBlock = 1u << (kBlockSide * kBlockSide);

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

/// All of that from the corners, clockwise on the screen.
inline TileTriangle tile_triangle(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c,
                                  const TileArea& area) {
    return {{tile_edge(a, b, area), tile_edge(b, c, area), tile_edge(c, a, area)},
            depth_plane(a, b, c, edge_function<double>(a.x, a.y, b.x, b.y, c.x, c.y)),
            tile_box(a, b, c, area)};
}

/// Is every sample of the tile inside all three edges, and nearer than what a tile is cleared with?
inline bool fills_tile(const TileTriangle& t, const TileArea& area) {
    const auto least = [&](const SampleEdge& e) {
        return e.start + std::min(e.step_x * (area.width - 1), 0) + std::min(e.step_y * (area.height - 1), 0);
    };
    return (least(t.edges.ab) | least(t.edges.bc) | least(t.edges.ca)) >= 0 && t.depth.z_max < kClearDepth;
}

/// Rows of a tile.
struct RowRange {
    std::int32_t first, last;  ///< both included; none if last < first
};

/// The rows of a range in which  most + step_y y >= 0.
inline RowRange rows_inside(std::int32_t most, std::int32_t step_y, RowRange rows) {
    const std::int32_t steepness = std::max(std::abs(step_y), 1);
    if (most < 0 && step_y <= 0) return {rows.first, -1};
    if (step_y > 0) rows.first = std::max(rows.first, (steepness - 1 - std::min(most, 0)) / steepness);
    if (step_y < 0) rows.last = std::min(rows.last, most / steepness);
    return rows;
}

/// The rows of the box in which some sample of so many columns from x on may lie inside all three edges: where the
/// edge function is negative at the first and at the last of them it is negative between them, too.
inline RowRange rows_of_columns(const TileTriangle& t, std::int32_t x, std::int32_t columns) {
    RowRange rows{t.box.y_first, t.box.y_last};
    for (const SampleEdge* e : {&t.edges.ab, &t.edges.bc, &t.edges.ca}) {
        rows = rows_inside(std::max(edge_at(*e, x, 0), edge_at(*e, x + columns - 1, 0)), e->step_y, rows);
    }
    return rows;
}

}  // namespace kreda::raster
