#include "examples/fragment_loop.hpp"

#include "raster/fragment_loop.hpp"

namespace kreda::examples {

FrameGeometry make_frame_geometry(std::vector<raster::MeshInstance> instances, const glm::mat4& clip_from_world,
                                  const raster::Viewport& viewport, const raster::VertexNeeds& needs,
                                  raster::CullMode cull) {
    FrameGeometry frame;
    frame.viewport = viewport;
    lay_out_vertices(instances, needs, frame.streams);
    transform_vertices(instances, clip_from_world, viewport, frame.streams);
    setup_triangles(instances, clip_from_world, viewport, cull, 1, frame.streams, frame.triangles);
    return frame;
}

void for_each_fragment(const FrameGeometry& frame, const raster::FragmentNeeds& needs,
                       raster::AttributeInterpolation interpolation,
                       const std::function<void(int, int, const raster::Fragments&, int)>& visit) {
    raster::for_each_fragment(frame.streams, frame.triangles, frame.viewport, needs, interpolation, visit);
}

}  // namespace kreda::examples
