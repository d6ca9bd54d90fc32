#include "raster/shading_points.hpp"

#include <algorithm>
#include <array>

#include <glm/vec2.hpp>

#include "raster/platform.hpp"

namespace kreda::raster {

namespace {

/// The places of a block, nearest to its middle first, else in reading order.
struct BlockOrder {
    std::array<glm::ivec2, kLargestShadingRate * kLargestShadingRate> place{};
    int count = 0;
};

BlockOrder order_of_block(int rate) {
    BlockOrder order;
    for (int y = 0; y < rate; ++y) {
        for (int x = 0; x < rate; ++x) order.place[static_cast<std::size_t>(order.count++)] = {x, y};
    }
    const auto distance2 = [rate](const glm::ivec2& p) {  // from the middle, in half samples
        const glm::ivec2 d = 2 * p - (rate - 1);
        return d.x * d.x + d.y * d.y;
    };
    std::stable_sort(order.place.begin(), order.place.begin() + order.count,
                     [&](const glm::ivec2& a, const glm::ivec2& b) { return distance2(a) < distance2(b); });
    return order;
}

/// What every step of the search reads and writes.
struct Search {
    const TileVisibility& tile;
    const TileArea& area;
    const TriangleSet& set;
    Run* runs;
    ShadingPoints& points;
    int found = 0;

    void add_point(int sample, std::uint32_t triangle) {
        runs[found++] = {static_cast<std::uint16_t>(sample % kTileSide),
                         static_cast<std::uint16_t>(sample / kTileSide),
                         1,
                         1,
                         set.triangle(triangle).material,
                         triangle};
    }

    /// The middle of a whole block: the last run goes on where that is the same triangle's block to the left.
    void add_middle(int sample, std::uint32_t triangle, int rate) {
        Run* const last = found > 0 ? runs + found - 1 : nullptr;
        const int next = last ? last->y * kTileSide + last->x + last->count * rate : -1;
        if (next != sample || last->triangle != triangle || sample % kTileSide < rate) {
            return add_point(sample, triangle);
        }
        last->step = static_cast<std::uint16_t>(rate);
        ++last->count;
    }
};

/// A whole block of one triangle: its middle stands for all. False where it is none.
bool take_whole_block(int top, int left, int rate, int middle, Search& search) {
    const int first = top * kTileSide + left;
    const std::uint32_t seen = search.tile.triangle[first];
    if (seen == kNoTriangle || left + rate > search.area.width || top + rate > search.area.height) return false;
    bool same = true;
    for (int y = 0; y < rate; ++y) {
        for (int x = 0; x < rate; ++x) same &= search.tile.triangle[first + y * kTileSide + x] == seen;
    }
    if (!same) return false;
    search.add_middle(first + middle, seen, rate);
    for (int y = 0; y < rate; ++y) {
        for (int x = 0; x < rate; ++x) {
            search.points.of[first + y * kTileSide + x] = static_cast<std::uint16_t>(first + middle);
        }
    }
    return true;
}

/// A block of several triangles, or at the edge of the picture: sample by sample.
void take_block(int top, int left, const BlockOrder& order, Search& search) {
    const int first_of_block = search.found;
    for (int k = 0; k < order.count; ++k) {
        const int x = left + order.place[static_cast<std::size_t>(k)].x;
        const int y = top + order.place[static_cast<std::size_t>(k)].y;
        if (x >= search.area.width || y >= search.area.height) continue;
        const int sample = y * kTileSide + x;
        const std::uint32_t seen = search.tile.triangle[sample];
        search.points.of[sample] = static_cast<std::uint16_t>(sample);
        if (seen == kNoTriangle) continue;
        const Run* const lit = std::find_if(search.runs + first_of_block, search.runs + search.found,
                                            [&](const Run& run) { return run.triangle == seen; });
        if (lit == search.runs + search.found) search.add_point(sample, seen);
        search.points.of[sample] = static_cast<std::uint16_t>(lit->y * kTileSide + lit->x);
    }
}

}  // namespace

int collect_shading_points(const TileVisibility& tile, const TileArea& area, const TriangleSet& set, int rate,
                           Run* runs, ShadingPoints& points) {
    const BlockOrder order = order_of_block(rate);
    const int middle = order.place[0].y * kTileSide + order.place[0].x;
    Search search{tile, area, set, runs, points};
    for (int top = 0; top < area.height; top += rate) {
        for (int left = 0; left < area.width; left += rate) {
            if (!take_whole_block(top, left, rate, middle, search)) take_block(top, left, order, search);
        }
    }
    return search.found;
}

KREDA_BATCH_LOOP void spread(const ShadingPoints& points, const TileArea& area, float* plane) {
    float row[kTileSide];
    for (int y = 0; y < area.height; ++y) {
        const std::uint16_t* const of = points.of + y * kTileSide;
        for (int x = 0; x < area.width; ++x) row[x] = plane[of[x]];
        for (int x = 0; x < area.width; ++x) plane[y * kTileSide + x] = row[x];
    }
}

}  // namespace kreda::raster
