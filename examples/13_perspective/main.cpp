// 13_perspective: a checkerboard interpolated affinely on the screen, and divided by w as perspective demands.
// Page docs/13_perspective.md | After 12_camera | New: AttributeInterpolation, interpolate_runs()
// Break at: run_weights | Look at: a.inv_w, weights.a.scale | Try: kSquares 2 and 32, target.y 0.6
#include <string>

#include "examples/draw.hpp"
#include "examples/example.hpp"
#include "examples/fragment_loop.hpp"
#include "raster/camera.hpp"
#include "raster/shapes.hpp"

using namespace kreda;
using namespace kreda::examples;
using raster::AttributeInterpolation;

namespace {

constexpr float kSquares = 8.0f;
const raster::Camera kCamera{.position = {0.3f, 0.6f, 1.45f}, .target = {0.0f, 0.08f, 0.0f}, .vertical_fov_deg = 55.0f};

/// Chalk or slate: in which square of the board does (u, v) lie?
glm::vec3 checker(float u, float v) {
    const int square = static_cast<int>(u * kSquares) + static_cast<int>(v * kSquares);
    return square % 2 == 0 ? kChalk : 0.35f * kBlue;
}

/// A square floor of detail x detail quads, two triangles each, with texture coordinates from 0 to 1.
Image draw_floor(glm::ivec2 size, int detail, AttributeInterpolation interpolation) {
    const raster::Mesh floor = raster::make_plane(detail);
    raster::MeshInstance instance;
    instance.mesh = &floor;
    instance.part_material = {0};
    const glm::mat4 clip_from_world = raster::clip_from_world(kCamera, raster::aspect_of(size.x, size.y));
    const FrameGeometry frame = make_frame_geometry({instance}, clip_from_world, {size.x, size.y}, {.uv = true});

    Image image = make_board(size.x, size.y);
    for_each_fragment(frame, {.uv = true}, interpolation, [&](int x, int y, const raster::Fragments& f, int i) {
        image.set_rgb(x, y, checker(f.u.at(i), f.v.at(i)));
    });
    return image;
}

void draw(const Options& options) {
    const auto floor_of = [&](glm::ivec2 panel, int detail, AttributeInterpolation interpolation) {
        return averaged(panel, options.samples,
                        [&](glm::ivec2 size) { return draw_floor(size, detail, interpolation); });
    };
    const glm::ivec2 half = panel_size(options.width, options.height, 2, 1);
    const Image affine = floor_of(half, 1, AttributeInterpolation::affine);
    const Image perspective = floor_of(half, 1, AttributeInterpolation::perspective);
    save_panels(options, "compare", 2, with_captions({affine, perspective}, {"affine", "perspective"}));

    // Smaller triangles hide the error of affine interpolation: so did the first game consoles.
    const glm::ivec2 quarter = panel_size(options.width, options.height, 2, 2);
    std::vector<Panel> panels;
    for (const int detail : {1, 2, 4, 16}) {
        panels.emplace_back(floor_of(quarter, detail, AttributeInterpolation::affine),
                            std::to_string(2 * detail * detail) + " triangles");
    }
    save_panels(options, "affine_subdivided", 2, panels);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "13_perspective", draw);
}
