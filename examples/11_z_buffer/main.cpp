// 11_z_buffer: two triangles run through each other. No drawing order is right; a depth for every pixel is.
// Page docs/11_z_buffer.md | After 10_triangle | New: VisibilityBuffer, DepthPlane, depth_at()
// Break at: rasterize_triangle | Look at: z, buffer.depth[sample] | Try: draw in another order, turn < into >
#include "examples/draw.hpp"
#include "examples/example.hpp"
#include "raster/depth.hpp"
#include "raster/rasterize_reference.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

/// Corners in normalized device coordinates: x and y from -1 to 1, y up, z from -1 (near) to 1 (far); w is 1.
constexpr glm::vec4 kCorners[2][3] = {
    {{-0.8f, 0.85f, -0.7f, 1.0f}, {0.85f, 0.1f, 0.7f, 1.0f}, {-0.65f, -0.65f, -0.7f, 1.0f}},  // orange, left edge near
    {{0.75f, -0.7f, -0.9f, 1.0f}, {-0.85f, -0.1f, 0.8f, 1.0f}, {0.65f, 0.9f, -0.3f, 1.0f}}};  // blue, right edge near
const glm::vec3 kColor[2] = {kOrange, kBlue};

/// Darker with distance, so that the eye sees which way a triangle leans.
glm::vec3 shade(int triangle, float z) {
    return (1.1f - z) * kColor[triangle];
}

raster::VertexStreams make_streams(const raster::Viewport& viewport) {
    raster::VertexStreams streams;
    for (const auto& corners : kCorners) {
        for (const glm::vec4& corner : corners) streams.screen.push_back(to_screen(corner, viewport));
    }
    return streams;
}

/// Without a depth test what is drawn last wins.
Image paint_in_order(const raster::Viewport& viewport, int first, int last) {
    const raster::VertexStreams streams = make_streams(viewport);
    Image image = make_board(viewport.width, viewport.height);
    for (const int t : {first, last}) {
        const raster::ScreenVertex* v = &streams.screen[3 * t];
        const std::int64_t area2 = raster::edge_function(v[0].x, v[0].y, v[1].x, v[1].y, v[2].x, v[2].y);
        const raster::DepthPlane plane = depth_plane(v[0], v[1], v[2], area2);
        for (int y = 0; y < viewport.height; ++y) {
            for (int x = 0; x < viewport.width; ++x) {
                if (!covers_sample(v[0], v[1], v[2], x, y)) continue;
                image.set_rgb(x, y, shade(t, depth_at(plane, depth_of_row(plane, y), x)));
            }
        }
    }
    return image;
}

/// With a depth test the nearest wins, whatever the order.
raster::VisibilityBuffer draw_with_depth(const raster::Viewport& viewport) {
    raster::VisibilityBuffer buffer(viewport.width, viewport.height);
    const raster::VertexStreams streams = make_streams(viewport);
    for (std::uint32_t t = 0; t < 2; ++t) rasterize_triangle(streams, {{3 * t, 3 * t + 1, 3 * t + 2}}, t, buffer);
    return buffer;
}

Image color_of_visible(const raster::VisibilityBuffer& buffer) {
    Image image = make_board(buffer.width, buffer.height);
    for (int y = 0; y < buffer.height; ++y) {
        for (int x = 0; x < buffer.width; ++x) {
            const int i = y * buffer.width + x;
            if (buffer.triangle[i] == raster::kNoTriangle) continue;
            image.set_rgb(x, y, shade(static_cast<int>(buffer.triangle[i]), buffer.depth[i]));
        }
    }
    return image;
}

void draw(const Options& options) {
    // The buffers hold n x n samples a pixel; a pixel of the pictures is their mean.
    const int n = options.samples;
    const raster::VisibilityBuffer buffer = draw_with_depth({n * options.width, n * options.height});
    save(options, "z_buffer", box_average(color_of_visible(buffer), n));
    save(options, "depth", box_average(grey_image(buffer.width, buffer.height, buffer.depth), n));

    const glm::ivec2 size = n * panel_size(options.width, options.height, 2, 2);
    const raster::Viewport small{size.x, size.y};
    const raster::VisibilityBuffer small_buffer = draw_with_depth(small);
    std::vector<Image> images = {paint_in_order(small, 0, 1), paint_in_order(small, 1, 0),
                                 color_of_visible(small_buffer), grey_image(size.x, size.y, small_buffer.depth)};
    for (Image& image : images) image = box_average(image, n);
    save_panels(options, "orders", 2,
                with_captions(images, {"blue drawn last", "orange drawn last", "z-buffer", "its depths"}));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "11_z_buffer", draw);
}
