// Run a plan: from the loaded scene to the linear film.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "raster/display_bytes.hpp"
#include "raster/image.hpp"
#include "raster/triangle_setup.hpp"
#include "raster/vertex_stage.hpp"
#include "scene/plan/plan.hpp"
#include "scene/scene.hpp"
#include "shadows/shadow_map.hpp"
#include "shadows/visible_sample_memory.hpp"

namespace kreda::scene {

struct Frame;
struct ShadowMemory;
struct TileScratch;

/// Maps that are being baked by the passes of a frame, and the cube map that they are baked from.
struct Baking {
    lighting::CubeMap radiance;
    std::shared_ptr<PreparedEnvironment> prepared;
};

/// The memory of a frame. Keep it from frame to frame and nothing is allocated twice; with `keeps_results` nothing that
/// a frame before left is computed twice, either: passes whose inputs are equal do not run (PlannedPass::inputs).
struct RenderBuffers {
    RenderBuffers();
    ~RenderBuffers();
    RenderBuffers(RenderBuffers&&) noexcept;
    RenderBuffers& operator=(RenderBuffers&&) noexcept;

    std::vector<raster::MeshInstance> instances;
    raster::VertexStreams streams;
    raster::TriangleSet triangles;
    shadows::VisibleSampleMemory visible;               ///< all samples at once, for shadows that are found that way
    std::vector<ShadowMemory> shadows;                  ///< one for each of the plan's shadows
    shadows::ShadowMapBuffers seen_by_light;            ///< what a shadow map is drawn from; each map in turn
    std::vector<std::vector<glm::vec3>> flat_color;     ///< flat shading: one a triangle, chunk by chunk
    std::vector<std::unique_ptr<TileScratch>> scratch;  ///< one a thread
    std::shared_ptr<const PreparedEnvironment>
        environment;                 ///< baked by the first frame that needs it, unless it is there
    std::unique_ptr<Baking> baking;  ///< while the passes bake
    bool keeps_results = false;
    raster::Image film;                ///< linear RGB radiance, row 0 on top
    raster::ByteImage bytes;           ///< in place of the film where the plan says so
    std::vector<raster::Image> views;  ///< one for each of the plan's views, as large as the film
    std::vector<int> tiles;            ///< the tiles to draw, in this order; empty: all, row by row
    std::vector<double> tile_ms;       ///< where it has room for all tiles: milliseconds that each took
};

/// Milliseconds of each pass, by the names and in the order of the plan. What threads do side by side, tile by tile and
/// batch by batch, is measured as a whole and divided among its passes as all threads together spent their time.
struct StageTimes {
    std::vector<std::pair<std::string, double>> stages;
    double total_ms = 0.0;    ///< of the frame, without what is baked before it and without display_ms
    double display_ms = 0.0;  ///< tone map and encoding in 8 bits: the pass "film" of a plan of bytes
};

struct RenderStatistics {
    StageTimes times;
    raster::TriangleCounts triangles;
    std::uint64_t samples_shaded = 0;  ///< visible samples, each shaded exactly once
    raster::ShownValues shown;         ///< of a picture in 8 bits
};

/// Render the scene into buffers.film, or buffers.bytes. threads = 0: as many as there are cores.
RenderStatistics render(const Scene& scene, const RenderPlan& plan, RenderBuffers& buffers, int threads = 0);

/// The same, and then look at the frame while everything in it is alive: what `kreda explain` asks about a pixel.
RenderStatistics render(const Scene& scene, const RenderPlan& plan, RenderBuffers& buffers, int threads,
                        const std::function<void(const Frame&)>& look);

/// The short way: plan, render, film.
[[nodiscard]] raster::Image render(const Scene& scene);

}  // namespace kreda::scene
