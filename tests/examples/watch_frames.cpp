// Linked with an example instead of scene/render/frame_done.cpp: looks at every frame that the example draws.
//   1. The fast rasterizer sees what the lecture's one sees: depth bits and triangle numbers of every sample.
//   2. What ran, and was measured, is the plan's list: the same names in the same order.
// Says how much it compared; the first difference ends the program with a failure.
#include "scene/render/frame_done.hpp"

#include <bit>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "raster/rasterize_reference.hpp"
#include "raster/rasterize_tile.hpp"
#include "scene/render/render.hpp"

namespace kreda::scene {

namespace {

[[noreturn]] void fail(const std::string& what) {
    std::fprintf(stderr, "%s\n", what.c_str());
    std::exit(1);
}

void check_visibility(const Frame& frame) {
    const RenderBuffers& buffers = frame.buffers;
    const raster::Viewport& viewport = frame.plan.viewport;
    const raster::VisibilityBuffer fast = rasterize_tiled(buffers.streams, buffers.triangles, viewport);
    const raster::VisibilityBuffer lecture = rasterize_reference(buffers.streams, buffers.triangles, viewport);
    for (std::size_t i = 0; i < fast.depth.size(); ++i) {
        const bool same_depth =
            std::bit_cast<std::uint32_t>(fast.depth[i]) == std::bit_cast<std::uint32_t>(lecture.depth[i]);
        if (same_depth && fast.triangle[i] == lecture.triangle[i]) continue;
        const std::size_t width = static_cast<std::size_t>(viewport.width);
        fail("the tiled rasterizer differs from the reference at sample " + std::to_string(i % width) + "," +
             std::to_string(i / width));
    }
    std::printf("visibility: %zu samples, the same as the reference\n", fast.depth.size());
}

void check_passes(const Frame& frame) {
    std::vector<std::string> planned, measured;
    for (const PlannedPass& pass : frame.plan.passes) planned.push_back(pass.name);
    for (const auto& [name, ms] : frame.statistics.times.stages) measured.push_back(name);
    std::string list;
    for (const std::string& name : measured) list += " | " + name;
    if (planned != measured) fail("measured were other passes than planned:" + list);
    std::printf("passes: %zu, as planned\n", planned.size());
}

}  // namespace

void frame_done(const Frame& frame) {
    if (!frame.scene.objects.empty()) check_visibility(frame);
    check_passes(frame);
}

}  // namespace kreda::scene
