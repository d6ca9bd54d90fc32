// What the camera sees of a scene, and which lights may reach it: all that can be known before anything is lit.
#pragma once

#include <cstdint>
#include <vector>

#include "raster/triangle_setup.hpp"
#include "scene/scene.hpp"

namespace kreda::scene {

struct RenderPlan;

/// What is seen of one object, and what became of its triangles.
struct SeenObject {
    std::uint64_t samples = 0;
    raster::TriangleCounts triangles;
};

struct Seen {
    std::uint64_t covered = 0;               ///< samples of the picture that show something
    std::vector<std::uint64_t> of_material;  ///< samples that show each of the scene's materials
    std::vector<SeenObject> objects;
    bool any_turned = false;  ///< normals of a seen triangle contradict its winding
    float farthest = 0.0f;    ///< no seen point is farther from the eye, world units
    /// For each of the scene's lights, the materials whose seen points it may reach. A bound: a light that reaches a
    /// seen triangle somewhere may still not reach the samples of it that are seen, and shadows are not asked.
    std::vector<std::vector<bool>> reached;
};

/// Find the visible triangles exactly as the renderer will: with the plan's sample grid and culling. Asks of the plan
/// also where light is computed.
[[nodiscard]] Seen look_at(const Scene& scene, const RenderPlan& plan);

}  // namespace kreda::scene
