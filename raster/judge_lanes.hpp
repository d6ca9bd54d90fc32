// Triangles judged side by side, a lane a triangle.
#pragma once

#include <algorithm>
#include <cstdint>

#include "raster/judge_triangle.hpp"
#include "raster/screen_lanes.hpp"
#include "raster/tile_grid.hpp"

namespace kreda::raster {

/// One corner of triangles that are judged side by side.
struct PointLanes {
    alignas(64) std::int32_t x[kScreenLanes], y[kScreenLanes];  ///< 1/256 sample

    /// Puts corner v at place i.
    void set(int i, const ScreenVertex& v) {
        x[i] = v.x;
        y[i] = v.y;
    }
    /// Corner i of them.
    [[nodiscard]] ScreenPoint at(int i) const {
        return {x[i], y[i]};
    }
};

/// Triangles, the judgements, and the tiles of those that are drawn.
struct JudgeLanes {
    PointLanes a, b, c;                                    ///< corners
    std::int32_t fate[kScreenLanes], front[kScreenLanes];  ///< of Judgement
    std::int32_t x_first[kScreenLanes], x_last[kScreenLanes], y_first[kScreenLanes], y_last[kScreenLanes];  ///< samples
    std::uint16_t x0[kScreenLanes], y0[kScreenLanes], x1[kScreenLanes], y1[kScreenLanes];                   ///< tiles

    /// Puts a judgement at place i.
    void set(int i, const Judgement& judgement) {
        fate[i] = static_cast<std::int32_t>(judgement.fate);
        front[i] = judgement.front;
        x_first[i] = judgement.x.first;
        x_last[i] = judgement.x.last;
        y_first[i] = judgement.y.first;
        y_last[i] = judgement.y.last;
    }
    /// Puts a range of tiles at place i.
    void set_tiles(int i, const TileRange& tiles) {
        x0[i] = tiles.x0;
        y0[i] = tiles.y0;
        x1[i] = tiles.x1;
        y1[i] = tiles.y1;
    }
    /// Tiles of triangle i.
    [[nodiscard]] TileRange tiles_at(int i) const {
        return {x0[i], y0[i], x1[i], y1[i]};
    }
    /// Judgement i of them.
    [[nodiscard]] Judgement at(int i) const {
        return {Fate{fate[i]}, front[i] != 0, {x_first[i], x_last[i]}, {y_first[i], y_last[i]}};
    }
};

/// How many of `count` fates are the wanted one.
inline int how_many(const std::int32_t* fate, int count, Fate wanted) {
    return static_cast<int>(std::count(fate, fate + count, static_cast<std::int32_t>(wanted)));
}

/// Fetch the corners of `count` triangles; `index` are their numbers in the instance, `screen` its vertices.
void fetch_corners(const ScreenVertex* screen, const std::uint32_t* index, int count, JudgeLanes& out);

/// Judge the triangles and look closer at them. Returns false if none of them is drawn or needs clipping: then there
/// are no tiles.
bool judge_triangles(int count, CullMode cull, Viewport viewport, TileGrid grid, JudgeLanes& lanes);

}  // namespace kreda::raster
