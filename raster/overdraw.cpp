#include "raster/overdraw.hpp"

namespace kreda::raster {

std::vector<std::uint32_t> count_overdraw(const VertexStreams& streams, const TriangleSet& set,
                                          const Viewport& viewport) {
    std::vector<std::uint32_t> covered(static_cast<std::size_t>(viewport.width) * viewport.height, 0);
    for (const TriangleChunk& chunk : set.chunks) {
        for (const ScreenTriangle& triangle : chunk.triangles) {
            const ScreenVertex& a = streams.screen[triangle.vertex[0]];
            const ScreenVertex& b = streams.screen[triangle.vertex[1]];
            const ScreenVertex& c = streams.screen[triangle.vertex[2]];
            const SampleBox box = sample_box(a, b, c, viewport.width, viewport.height);
            for (int y = box.y_first; y <= box.y_last; ++y) {
                std::uint32_t* row = &covered[static_cast<std::size_t>(y) * viewport.width];
                for (int x = box.x_first; x <= box.x_last; ++x) row[x] += covers_sample(a, b, c, x, y) ? 1 : 0;
            }
        }
    }
    return covered;
}

}  // namespace kreda::raster
