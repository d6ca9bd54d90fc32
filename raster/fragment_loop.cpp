#include "raster/fragment_loop.hpp"

#include <memory>
#include <vector>

namespace kreda::raster {

void for_each_fragment(const VertexStreams& streams, const TriangleSet& triangles, const Viewport& viewport,
                       const FragmentNeeds& needs, AttributeInterpolation interpolation,
                       const std::function<void(int, int, const Fragments&, int)>& visit) {
    const auto tile = std::make_unique<TileVisibility>();
    const auto fragments = std::make_unique<Fragments>();
    std::vector<Run> runs(kTileSide * kTileSide);
    const TileGrid& grid = triangles.grid;
    for (int t = 0; t < grid.columns * grid.rows; ++t) {
        const TileArea area = tile_area(grid, viewport, t);
        rasterize_tile(streams, triangles, area, *tile);
        const int run_count = collect_runs(*tile, area, triangles, runs.data());
        for (int r = 0; r < run_count; ++r) {
            interpolate_runs(streams, triangles, area, &runs[r], 1, needs, interpolation, *fragments);
            for (int i = 0; i < runs[r].count; ++i) visit(area.x + runs[r].x + i, area.y + runs[r].y, *fragments, i);
        }
    }
}

}  // namespace kreda::raster
