#include "raster/rasterize_reference.hpp"

#include "raster/depth.hpp"

namespace kreda::raster {

void rasterize_triangle(const VertexStreams& streams, const ScreenTriangle& triangle, std::uint32_t id,
                        VisibilityBuffer& buffer) {
    const ScreenVertex& a = streams.screen[triangle.vertex[0]];
    const ScreenVertex& b = streams.screen[triangle.vertex[1]];
    const ScreenVertex& c = streams.screen[triangle.vertex[2]];
    const DepthPlane plane = depth_plane(a, b, c, edge_function(a.x, a.y, b.x, b.y, c.x, c.y));
    const SampleBox box = sample_box(a, b, c, buffer.width, buffer.height);
    for (int y = box.y_first; y <= box.y_last; ++y) {
        for (int x = box.x_first; x <= box.x_last; ++x) {
            if (!covers_sample(a, b, c, x, y)) continue;

            const float z = depth_at(plane, depth_of_row(plane, y), x);
            const std::size_t sample = static_cast<std::size_t>(y) * buffer.width + x;
            if (z < buffer.depth[sample]) {
                buffer.depth[sample] = z;
                buffer.triangle[sample] = id;
            }
        }
    }
}

VisibilityBuffer rasterize_reference(const VertexStreams& streams, const TriangleSet& set, const Viewport& viewport) {
    VisibilityBuffer buffer(viewport.width, viewport.height);
    for (std::size_t c = 0; c < set.chunks.size(); ++c) {
        for (std::size_t i = 0; i < set.chunks[c].triangles.size(); ++i) {
            rasterize_triangle(streams, set.chunks[c].triangles[i], triangle_id(c, i), buffer);
        }
    }
    return buffer;
}

}  // namespace kreda::raster
