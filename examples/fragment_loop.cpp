#include "examples/fragment_loop.hpp"

#include <memory>

namespace kreda::examples {

Frame make_frame(std::vector<raster::MeshInstance> instances, const glm::mat4& clip_from_world,
                 const raster::Viewport& viewport, const raster::VertexNeeds& needs, raster::CullMode cull) {
    Frame frame;
    frame.viewport = viewport;
    lay_out_vertices(instances, needs, frame.streams);
    transform_vertices(instances, clip_from_world, viewport, frame.streams);
    setup_triangles(instances, clip_from_world, viewport, cull, 1, frame.streams, frame.triangles);
    return frame;
}

void for_each_fragment(const Frame& frame, const raster::FragmentNeeds& needs,
                       raster::AttributeInterpolation interpolation,
                       const std::function<void(int, int, const raster::Fragments&, int)>& visit) {
    const auto tile = std::make_unique<raster::TileVisibility>();
    const auto fragments = std::make_unique<raster::Fragments>();
    std::vector<raster::Run> runs(raster::kTileSide * raster::kTileSide);
    const raster::TileGrid& grid = frame.triangles.grid;
    for (int t = 0; t < grid.columns * grid.rows; ++t) {
        const raster::TileArea area = tile_area(grid, frame.viewport, t);
        rasterize_tile(frame.streams, frame.triangles, area, *tile);
        const int run_count = find_runs(*tile, area, frame.triangles, runs.data());
        for (int r = 0; r < run_count; ++r) {
            interpolate_runs(frame.streams, frame.triangles, area, &runs[r], 1, needs, interpolation, *fragments);
            for (int i = 0; i < runs[r].count; ++i) visit(area.x + runs[r].x + i, area.y + runs[r].y, *fragments, i);
        }
    }
}

}  // namespace kreda::examples
