#include "shadows/visible_sample_memory.hpp"

#include <algorithm>
#include <memory>

#include "raster/rasterize_tile.hpp"

namespace kreda::shadows {

namespace {

using raster::kTileSide;

/// What one thread needs for a tile.
struct Scratch {
    raster::TileVisibility visibility;
    raster::Run runs[kTileSide * kTileSide];
    raster::Fragments fragments;
};

void copy_visibility(const raster::TileVisibility& tile, const raster::TileArea& area, VisibleSampleMemory& frame) {
    for (int y = 0; y < area.height; ++y) {
        const std::size_t to = static_cast<std::size_t>(area.y + y) * frame.viewport.width + area.x;
        std::copy_n(&tile.depth[y * kTileSide], area.width, &frame.depth[to]);
        std::copy_n(&tile.triangle[y * kTileSide], area.width, &frame.triangle[to]);
        std::fill_n(&frame.position[to], area.width, glm::vec3(0.0f));
    }
}

}  // namespace

std::size_t bytes_to_find_visible() {
    return sizeof(Scratch);
}

void find_visible(const raster::VertexStreams& streams, const raster::TriangleSet& set,
                  raster::AttributeInterpolation interpolation, const raster::Viewport& viewport,
                  const glm::mat4& clip_from_world, VisibleSampleMemory& frame) {
    frame.viewport = viewport;
    frame.clip_from_world = clip_from_world;
    const std::size_t count = static_cast<std::size_t>(viewport.width) * viewport.height;
    frame.depth.resize(count);
    frame.position.resize(count);
    frame.triangle.resize(count);
    raster::FragmentNeeds needs;
    needs.position = true;
    const int tile_count = set.grid.columns * set.grid.rows;
#pragma omp parallel
    {
        const auto scratch = std::make_unique<Scratch>();
#pragma omp for schedule(dynamic)
        for (int t = 0; t < tile_count; ++t) {
            const raster::TileArea area = tile_area(set.grid, viewport, t);
            rasterize_tile(streams, set, area, scratch->visibility);
            copy_visibility(scratch->visibility, area, frame);
            const int run_count = collect_runs(scratch->visibility, area, set, scratch->runs);
            for (int r = 0; r < run_count; ++r) {
                const raster::Run& run = scratch->runs[r];
                interpolate_runs(streams, set, area, &run, 1, needs, interpolation, scratch->fragments);
                const std::size_t to = static_cast<std::size_t>(area.y + run.y) * viewport.width + area.x + run.x;
                for (int i = 0; i < run.count; ++i) frame.position[to + i] = scratch->fragments.position.at(i);
            }
        }
    }
}

}  // namespace kreda::shadows
