// 14_clipping: what lies behind the camera must go before the division by w; what sticks out at the sides may stay.
// Page docs/14_clipping.md | After 12_camera | New: clip_triangle(), ClipPolygon, guard band
// Break at: clip_triangle | Look at: polygon.count, polygon.vertex[i].weights | Try: kCamera.near 0.2, kGuard 1
#include <algorithm>

#include <glm/ext/matrix_transform.hpp>

#include "examples/draw.hpp"
#include "examples/example.hpp"
#include "raster/camera.hpp"
#include "raster/clip.hpp"

using namespace kreda;
using namespace kreda::examples;
using Corners = glm::vec2[3];

namespace {

const raster::Camera kCamera{.position = {0.0f, 0.6f, 2.0f},
                             .target = {0.0f, 0.35f, 0.0f},
                             .vertical_fov_deg = 75.0f,
                             .near = 1.0f,
                             .far = 6.0f};
constexpr float kGuard = 2.0f;  ///< half side of the guard band, for the picture; raster/screen.hpp has the real one
constexpr glm::vec2 kSquare[4] = {{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}};

/// A road that starts behind the camera.
const glm::vec4 kRoad[3] = {{0.2f, 0.0f, -3.5f, 1.0f}, {-1.6f, 0.0f, 2.9f, 1.0f}, {1.3f, 0.0f, 2.4f, 1.0f}};

/// Where a clip-space position lies on the picture; right only for w > 0.
glm::vec2 on_picture(const Image& image, const glm::vec4& clip) {
    return glm::vec2(0.5f + 0.5f * clip.x / clip.w, 0.5f - 0.5f * clip.y / clip.w) *
           glm::vec2(image.width, image.height);
}

/// A clipped polygon: filled, outlined, kept corners yellow, new ones red.
void draw_polygon(Image& image, const raster::ClipPolygon& polygon, const glm::mat4& picture_from_clip,
                  const glm::vec3& color) {
    const float line = 0.012f * float(image.height);
    const auto corner = [&](int i) {
        return on_picture(image, picture_from_clip * polygon.vertex[i % polygon.count].position);
    };
    for (int i = 2; i < polygon.count; ++i) fill_triangle(image, {corner(0), corner(i - 1), corner(i)}, color);
    for (int i = 0; i < polygon.count; ++i) draw_line(image, corner(i), corner(i + 1), line, kChalk);
    for (int i = 0; i < polygon.count; ++i) {
        const glm::vec3 w = polygon.vertex[i].weights;
        const bool is_new = std::max({w.x, w.y, w.z}) < 1.0f;
        draw_disc(image, corner(i), 2.0f * line, is_new ? kRed : kYellow);
    }
}

/// The part of the road before the near plane (and before the far one, and within a guard band that is wide enough).
raster::ClipPolygon clip_road(const glm::mat4& clip_from_world) {
    return raster::clip_triangle(clip_from_world * kRoad[0], clip_from_world * kRoad[1], clip_from_world * kRoad[2],
                                 1000.0f, 1000.0f);
}

/// Camera, near plane and road seen by an observer from the side.
Image draw_from_outside(glm::ivec2 size) {
    const raster::Camera observer{
        .position = {-5.5f, 3.4f, 4.2f}, .target = {0.1f, 0.0f, 0.2f}, .vertical_fov_deg = 32.0f};
    const glm::mat4 from_world = clip_from_world(observer, raster::aspect_of(size.x, size.y));
    const glm::mat4 clip = clip_from_world(kCamera, 16.0f / 9.0f);
    Image image = make_board(size.x, size.y);
    Corners road;
    for (int i = 0; i < 3; ++i) road[i] = on_picture(image, from_world * kRoad[i]);
    fill_triangle(image, road, kSlate);
    draw_polygon(image, clip_road(clip), from_world * glm::inverse(clip), 0.5f * kBlue);
    const glm::vec2 eye = on_picture(image, from_world * glm::vec4(kCamera.position, 1.0f));
    for (int i = 0; i < 4; ++i) {
        const auto near_plane = [&](int k) {
            return on_picture(image, from_world * glm::inverse(clip) * glm::vec4(kSquare[k % 4], -1.0f, 1.0f));
        };
        draw_line(image, near_plane(i), near_plane(i + 1), 0.012f * float(size.y), kOrange);
        draw_line(image, eye, near_plane(i), 0.008f * float(size.y), kOrange);
    }
    draw_disc(image, eye, 0.025f * float(size.y), kOrange);
    return image;
}

/// What the camera sees of the clipped road, and what dividing by a negative w makes of it.
Image draw_from_camera(glm::ivec2 size, bool clipped) {
    const glm::mat4 clip = clip_from_world(kCamera, raster::aspect_of(size.x, size.y));
    Image image = make_board(size.x, size.y);
    if (clipped) {
        draw_polygon(image, clip_road(clip), glm::mat4(1.0f), 0.5f * kBlue);
        return image;
    }
    Corners road;
    for (int i = 0; i < 3; ++i) road[i] = on_picture(image, clip * kRoad[i]);
    fill_triangle(image, road, 0.5f * kRed);
    draw_triangle_outline(image, road, 0.012f * float(size.y), kChalk);
    return image;
}

/// Screen (chalk) and a guard band twice as large (orange), seen from the front: only the triangle that leaves
/// the band is cut.
Image draw_guard_band(glm::ivec2 size) {
    const glm::vec4 triangles[3][3] = {{{-0.3f, -0.6f, 0, 1}, {-0.1f, 0.7f, 0, 1}, {0.5f, -0.3f, 0, 1}},
                                       {{-0.6f, -0.8f, 0, 1}, {-1.8f, 0.3f, 0, 1}, {-0.4f, 0.8f, 0, 1}},
                                       {{0.5f, 0.1f, 0, 1}, {1.5f, 2.5f, 0, 1}, {2.6f, -0.7f, 0, 1}}};
    const glm::mat4 smaller = glm::translate(glm::mat4(1.0f), {0.0f, 0.14f, 0.0f}) * glm::mat4(glm::mat3(0.36f));
    const glm::vec3 colors[3] = {0.5f * kBlue, 0.5f * kGreen, 0.5f * kOrange};
    Image image = make_board(size.x, size.y);
    for (int t = 0; t < 3; ++t) {
        const glm::vec4(&corner)[3] = triangles[t];
        Corners whole;
        for (int i = 0; i < 3; ++i) whole[i] = on_picture(image, smaller * corner[i]);
        fill_triangle(image, whole, kSlate);
        draw_polygon(image, raster::clip_triangle(corner[0], corner[1], corner[2], kGuard, kGuard), smaller, colors[t]);
    }
    for (const float side : {1.0f, kGuard}) {
        const glm::vec3 color = side == 1.0f ? kChalk : kOrange;
        for (int i = 0; i < 4; ++i) {
            const auto at = [&](int k) { return glm::vec4(side * kSquare[k % 4], 0.0f, 1.0f); };
            draw_line(image, on_picture(image, smaller * at(i)), on_picture(image, smaller * at(i + 1)),
                      0.008f * float(size.y), color);
        }
    }
    return image;
}

void draw(const Options& options) {
    const glm::ivec2 quarter = panel_size(options.width, options.height, 2, 2);
    const auto drawn = [&](auto draw_one) { return averaged(quarter, options.samples, draw_one); };
    const std::vector<Image> images = {
        drawn(draw_from_outside), drawn([](glm::ivec2 size) { return draw_from_camera(size, true); }),
        drawn(draw_guard_band), drawn([](glm::ivec2 size) { return draw_from_camera(size, false); })};
    save_panels(options, "clipping", 2,
                as_drawings(with_captions(
                    images, {"cut at the near plane", "the camera's view", "guard band", "not cut: upside down"})));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "14_clipping", draw);
}
