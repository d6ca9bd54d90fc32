// The whole pipeline on one page, a triangle at a time: vertex, clip, cover, interpolate, visit. Slow, short, without
// tiles, threads or batches, and the judge of the fast one, which gives the same bits.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "raster/judge_triangle.hpp"
#include "raster/vertex_stage.hpp"

namespace kreda::raster {

/// What the mesh says of a vertex, in world space, or a blend of three of them.
struct VertexAttributes {
    glm::vec3 position{0.0f};  ///< world space
    glm::vec3 normal{0.0f};    ///< not normalized
    glm::vec2 uv{0.0f};        ///< texture coordinates
};

/// A visible sample with what its triangle has there.
struct ReferenceSample {
    int x = 0, y = 0;             ///< on the sample grid, (0, 0) in the upper left corner
    float depth = 1.0f;           ///< window depth, 0 at the near plane, 1 at the far plane
    std::uint32_t source = 0;     ///< number of the triangle, counted over all instances
    VertexAttributes attributes;  ///< interpolated there, correct in perspective
};

/// Draw all visible parts of the instances in order, then visit every sample that shows one, row by row from the top.
/// Where a mesh has no normals or no texture coordinates they are 0.
void draw_reference(const std::vector<MeshInstance>& instances, const glm::mat4& clip_from_world,
                    const Viewport& viewport, CullMode cull, const std::function<void(const ReferenceSample&)>& visit);

}  // namespace kreda::raster
