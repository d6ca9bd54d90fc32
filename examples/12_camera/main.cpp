// 12_camera: one corner of a cube on its way to the screen: object, world, view, clip, normalized device, window.
// Page docs/12_camera.md | After 10_triangle | New: Camera, view_from_world(), clip_from_view(), to_screen()
// Break at: to_screen | Look at: clip, ndc, window | Try: vertical_fov_deg 20 and 90, projection orthographic
#include <array>
#include <cstdio>
#include <string>

#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "examples/example.hpp"
#include "examples/number_table.hpp"
#include "raster/camera.hpp"
#include "raster/screen.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

constexpr glm::vec3 kCorner{1.0f, 1.0f, 1.0f};  ///< the corner we follow, object space
const raster::Camera kCamera{
    .position = {1.2f, 1.6f, 4.4f}, .target = {0.2f, 0.0f, 0.0f}, .vertical_fov_deg = 40.0f, .near = 1.8f, .far = 6.5f};

/// The cube of [-1, 1]^3 is made smaller, turned and moved.
glm::mat4 world_from_object() {
    const glm::mat4 moved = glm::translate(glm::mat4(1.0f), {-0.3f, 0.2f, 0.0f});
    const glm::mat4 turned = glm::mat4(glm::rotate(glm::dmat4(1.0), glm::radians(30.0), glm::dvec3(0.0, 1.0, 0.0)));
    return moved * turned * glm::scale(glm::mat4(1.0f), glm::vec3(0.6f));
}

glm::vec2 window_position(const Image& image, const glm::vec4& clip) {
    const raster::ScreenVertex v = raster::to_screen(clip, {image.width, image.height});
    return glm::vec2(v.x, v.y) / float(raster::kSubpixels);
}

/// The 12 edges of the box [-1, 1]^3, or of what a matrix makes of it, drawn by another matrix.
void draw_box(Image& image, const glm::mat4& clip_from_box, float width, const glm::vec3& color) {
    const auto window = [&](int corner) {
        const glm::vec3 p(corner & 1 ? 1.0f : -1.0f, corner & 2 ? 1.0f : -1.0f, corner & 4 ? 1.0f : -1.0f);
        return window_position(image, clip_from_box * glm::vec4(p, 1.0f));
    };
    for (int corner = 0; corner < 8; ++corner) {
        for (const int axis : {1, 2, 4}) {
            if ((corner & axis) == 0) draw_line(image, window(corner), window(corner | axis), width, color);
        }
    }
}

void draw_axis(Image& image, const glm::mat4& clip_from_space, glm::vec3 direction, const glm::vec3& color) {
    const glm::vec2 origin = window_position(image, clip_from_space * glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    const glm::vec2 end = window_position(image, clip_from_space * glm::vec4(direction, 1.0f));
    draw_line(image, origin, end, 0.015f * float(image.height), color);
}

/// One space seen by an observer from outside: its axes, the cube, and the frustum (what the camera sees).
/// Normalized device space is left-handed (z away from the eye): handedness -1.
Panel draw_space(glm::ivec2 size, const char* name, const glm::mat4& space_from_world, const raster::Camera& observer,
                 const glm::vec3* eye, float handedness) {
    const glm::mat4 mirror = glm::scale(glm::mat4(1.0f), {1.0f, 1.0f, handedness});
    const glm::mat4 clip_from_space = clip_from_world(observer, raster::aspect_of(size.x, size.y)) * mirror;
    const glm::mat4 world_from_clip = glm::inverse(clip_from_world(kCamera, 16.0f / 9.0f));
    const float line = 0.008f * float(size.y);
    Image image = make_board(size.x, size.y);
    draw_axis(image, clip_from_space, {1.0f, 0.0f, 0.0f}, kRed);
    draw_axis(image, clip_from_space, {0.0f, 1.0f, 0.0f}, kGreen);
    draw_axis(image, clip_from_space, {0.0f, 0.0f, 1.0f}, kBlue);
    if (eye) draw_disc(image, window_position(image, clip_from_space * glm::vec4(*eye, 1.0f)), 3.0f * line, kOrange);
    draw_box(image, clip_from_space * space_from_world * world_from_clip, line, kDust);
    draw_box(image, clip_from_space * space_from_world * world_from_object(), 1.5f * line, kChalk);
    const glm::mat4 clip_from_object = clip_from_space * space_from_world * world_from_object();
    draw_disc(image, window_position(image, clip_from_object * glm::vec4(kCorner, 1.0f)), 3.0f * line, kYellow);
    return {image, name};
}

/// The corner's coordinates in every space, printed and as a picture.
void draw_table(const Options& options) {
    const raster::Viewport viewport{640, 360};
    const glm::vec4 world = world_from_object() * glm::vec4(kCorner, 1.0f);
    const glm::vec4 view = view_from_world(kCamera) * world;
    const glm::vec4 clip = clip_from_view(kCamera, 16.0f / 9.0f) * view;
    const raster::ScreenVertex screen = raster::to_screen(clip, viewport);
    const glm::vec4 window(float(screen.x) / 256.0f, float(screen.y) / 256.0f, screen.z, screen.inv_w);
    const std::array<NumberRow, 6> rows = {number_row("object", glm::vec4(kCorner, 1.0f), 4),
                                           number_row("world", world, 4),
                                           number_row("view", view, 4),
                                           number_row("clip", clip, 4),
                                           number_row("clip/w", clip / clip.w, 3),
                                           number_row("window", window, 3)};
    Panel table = empty_panel({options.width, options.height});
    const float line = float(options.height) / 9.0f, size = 1.2f * caption_size(options.height);
    add_row(table, {"", "$x$", "$y$", "$z$", "$w$"}, 1.6f * line, size, kYellow);
    std::printf("               x        y        z        w\n");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const NumberRow& r = rows[i];
        std::printf("%-8s%9s%9s%9s%9s\n", r[0].c_str(), r[1].c_str(), r[2].c_str(), r[3].c_str(), r[4].c_str());
        add_row(table, r, (2.6f + float(i)) * line, size, kChalk);
    }
    save_panel(options, "table", table);
}

void draw(const Options& options) {
    const raster::Camera outside{
        .position = {-11.0f, 6.5f, 8.0f}, .target = {0.3f, 0.2f, 1.0f}, .vertical_fov_deg = 40.0f};
    const raster::Camera beside{
        .position = {-10.0f, 5.5f, 4.5f}, .target = {0.0f, 0.1f, -3.3f}, .vertical_fov_deg = 40.0f};
    const raster::Camera close{
        .position = {-2.2f, 2.0f, 4.4f}, .target = {0.0f, 0.0f, 0.0f}, .vertical_fov_deg = 40.0f};
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 2);
    const glm::mat4 view = view_from_world(kCamera);
    const glm::mat4 clip = clip_from_world(kCamera, 16.0f / 9.0f);
    const glm::vec3 origin(0.0f);
    Image window = make_board(size.x, size.y);
    draw_box(window, clip * world_from_object(), 0.02f * float(size.y), kChalk);
    draw_disc(window, window_position(window, clip * world_from_object() * glm::vec4(kCorner, 1.0f)),
              0.024f * float(size.y), kYellow);
    save_panels(options, "spaces", 2,
                as_drawings({draw_space(size, "world", glm::mat4(1.0f), outside, &kCamera.position, 1.0f),
                             draw_space(size, "view", view, beside, &origin, 1.0f),
                             draw_space(size, "clip / $w$", clip, close, nullptr, -1.0f),
                             {window, "window"}}));
    draw_table(options);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "12_camera", draw);
}
