// Runs of a tile: samples of a row that see the same triangle.
#include <algorithm>
#include <bit>

#include "raster/fragments.hpp"

namespace kreda::raster {

namespace {

/// Bit x of begins[y] is set where the triangle of sample (x, y) differs from its left neighbour's, and for x = 0.
KREDA_BATCH_LOOP void mark_beginnings(const TileVisibility& tile, int rows, std::uint64_t* __restrict begins) {
    alignas(64) std::uint64_t bit[kTileSide];
    for (int x = 0; x < kTileSide; ++x) bit[x] = std::uint64_t{1} << x;
    for (int y = 0; y < rows; ++y) {
        const std::uint32_t* row = &tile.triangle[y * kTileSide];
        std::uint64_t mask = 1;
        for (int x = 1; x < kTileSide; ++x) mask |= row[x] != row[x - 1] ? bit[x] : 0;
        begins[y] = mask;
    }
}

}  // namespace

int collect_runs(const TileVisibility& tile, const TileArea& area, const TriangleSet& set, Run* runs) {
    int found = 0;
    std::uint64_t begins[kTileSide];
    mark_beginnings(tile, area.height, begins);
    for (int y = 0; y < area.height; ++y) {
        const std::uint32_t* row = &tile.triangle[y * kTileSide];
        std::uint64_t rest = begins[y];
        for (int x = 0; x < area.width;) {
            rest &= rest - 1;  // forget where this run begins; what is left begins later
            const int end = std::min(rest ? std::countr_zero(rest) : kTileSide, area.width);
            if (row[x] != kNoTriangle) {
                runs[found++] = {static_cast<std::uint16_t>(x),       static_cast<std::uint16_t>(y),
                                 static_cast<std::uint16_t>(end - x), 1,
                                 set.triangle(row[x]).material,       row[x]};
            }
            x = end;
        }
    }
    return found;
}

}  // namespace kreda::raster
