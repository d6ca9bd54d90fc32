#include "raster/judge_lanes.hpp"

#include "raster/platform.hpp"

namespace kreda::raster {

// Not in a batch loop: instructions that gather are slower than plain loads.
void fetch_corners(const ScreenVertex* screen, const std::uint32_t* index, int count, JudgeLanes& out) {
    for (int i = 0; i < count; ++i) {
        out.a.set(i, screen[index[3 * i]]);
        out.b.set(i, screen[index[3 * i + 1]]);
        out.c.set(i, screen[index[3 * i + 2]]);
    }
}

KREDA_BATCH_LOOP bool judge_triangles(int count, CullMode cull, Viewport viewport, TileGrid grid, JudgeLanes& out) {
    const int lanes = lanes_for(count);
    for (int i = 0; i < lanes; ++i) out.set(i, judge(out.a.at(i), out.b.at(i), out.c.at(i), cull, viewport));
    // Neighbours often face away together.
    if (how_many(out.fate, count, Fate::drawn) == 0) return how_many(out.fate, count, Fate::needs_clip) > 0;
    for (int i = 0; i < lanes; ++i) {
        const Judgement judgement = out.at(i);
        out.fate[i] = static_cast<std::int32_t>(look_closer(out.a.at(i), out.b.at(i), out.c.at(i), judgement));
        out.set_tiles(i, tiles_of(grid, judgement.x, judgement.y));
    }
    return true;
}

}  // namespace kreda::raster
