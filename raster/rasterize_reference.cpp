#include "raster/rasterize_reference.hpp"

#include <algorithm>

#include "raster/depth.hpp"

namespace kreda::raster {

void rasterize_triangle(const VertexStreams& streams, const ScreenTriangle& triangle, std::uint32_t id,
                        VisibilityBuffer& buffer) {
    const ScreenVertex& a = streams.screen[triangle.vertex[0]];
    const ScreenVertex& b = streams.screen[triangle.vertex[1]];
    const ScreenVertex& c = streams.screen[triangle.vertex[2]];
    const DepthPlane plane = depth_plane(a, b, c, edge_function(a.x, a.y, b.x, b.y, c.x, c.y));

    // A centre exactly on an edge (E = 0) is inside only for top and left edges: the others ask for E > 0.
    const std::int64_t least_ab = is_top_left(b.x - a.x, b.y - a.y) ? 0 : 1;
    const std::int64_t least_bc = is_top_left(c.x - b.x, c.y - b.y) ? 0 : 1;
    const std::int64_t least_ca = is_top_left(a.x - c.x, a.y - c.y) ? 0 : 1;

    const int x_first = std::max(std::min({a.x, b.x, c.x}) >> kSubpixelBits, 0);
    const int y_first = std::max(std::min({a.y, b.y, c.y}) >> kSubpixelBits, 0);
    const int x_last = std::min(std::max({a.x, b.x, c.x}) >> kSubpixelBits, buffer.width - 1);
    const int y_last = std::min(std::max({a.y, b.y, c.y}) >> kSubpixelBits, buffer.height - 1);

    for (int y = y_first; y <= y_last; ++y) {
        for (int x = x_first; x <= x_last; ++x) {
            const std::int64_t p_x = x * kSubpixels + kPixelCentre;
            const std::int64_t p_y = y * kSubpixels + kPixelCentre;
            const bool inside = edge_function(a.x, a.y, b.x, b.y, p_x, p_y) >= least_ab &&
                                edge_function(b.x, b.y, c.x, c.y, p_x, p_y) >= least_bc &&
                                edge_function(c.x, c.y, a.x, a.y, p_x, p_y) >= least_ca;
            if (!inside) continue;

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
