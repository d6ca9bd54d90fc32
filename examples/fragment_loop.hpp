// From mesh instances to visible fragments, one after another: what scene/render/render.cpp does, without lighting.
#pragma once

#include <functional>
#include <vector>

#include "raster/fragments.hpp"

namespace kreda::examples {

/// What is drawn from where: the vertex streams and the triangles of one frame.
struct FrameGeometry {
    raster::Viewport viewport;
    raster::VertexStreams streams;
    raster::TriangleSet triangles;
};

/// Vertices -> screen triangles, culled and clipped.
[[nodiscard]] FrameGeometry make_frame_geometry(std::vector<raster::MeshInstance> instances,
                                                const glm::mat4& clip_from_world, const raster::Viewport& viewport,
                                                const raster::VertexNeeds& needs,
                                                raster::CullMode cull = raster::CullMode::back);

/// Calls visit(x, y, fragments, i) for every covered sample with its interpolated attributes.
void for_each_fragment(const FrameGeometry& frame, const raster::FragmentNeeds& needs,
                       raster::AttributeInterpolation interpolation,
                       const std::function<void(int, int, const raster::Fragments&, int)>& visit);

}  // namespace kreda::examples
