// 15_mesh: corners, triangles that share them, and a normal at each corner: flat or smooth.
// Page docs/15_mesh.md | After 12_camera | New: Mesh, load_mesh_file(), make_smooth_normals(), make_flat_normals()
// Break at: load_mesh_file | Look at: mesh.positions, mesh.indices, mesh.normals | Try: detail 2 for the teapot
#include <algorithm>
#include <cstdio>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "examples/draw.hpp"
#include "examples/example.hpp"
#include "examples/fragment_loop.hpp"
#include "raster/camera.hpp"
#include "raster/normals.hpp"
#include "raster/shapes.hpp"
#include "scene/files/mesh_file.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

const raster::Camera kCamera{
    .position = {1.0f, 1.0f, 3.2f}, .target = {0.08f, -0.03f, 0.0f}, .vertical_fov_deg = 27.0f};

FrameGeometry frame_of(const raster::Mesh& mesh, const glm::mat4& world_from_object, glm::ivec2 size) {
    raster::MeshInstance instance;
    instance.mesh = &mesh;
    instance.world_from_object = world_from_object;
    instance.part_material.assign(mesh.parts.size(), 0);
    const glm::mat4 clip = raster::clip_from_world(kCamera, raster::aspect_of(size.x, size.y));
    return make_frame_geometry({instance}, clip, {size.x, size.y}, {.normal_world = true});
}

/// Hidden lines vanish by themselves: an edge is where samples `line` apart, side by side, see different triangles.
Image draw_wireframe(const FrameGeometry& frame, int line) {
    const raster::VisibilityBuffer buffer = rasterize_tiled(frame.streams, frame.triangles, frame.viewport);
    Image image = make_board(buffer.width, buffer.height);
    for (int y = 0; y + line < buffer.height; ++y) {
        for (int x = 0; x + line < buffer.width; ++x) {
            const std::uint32_t* here = &buffer.triangle[y * buffer.width + x];
            const bool edge = here[0] != here[line] || here[0] != here[line * buffer.width];
            if (here[0] != raster::kNoTriangle) image.set_rgb(x, y, kSlate);
            if (edge) image.set_rgb(x, y, kChalk);
        }
    }
    return image;
}

/// A unit normal as a colour: x, y and z from -1..1 to red, green and blue from 0 to 255 in the file.
glm::vec3 color_of_normal(const glm::vec3& n) {
    const glm::vec3 encoded = 0.5f * n + 0.5f;
    return {raster::linear_from_srgb(encoded.x), raster::linear_from_srgb(encoded.y),
            raster::linear_from_srgb(encoded.z)};
}

Image draw_normals(const FrameGeometry& frame) {
    Image image = make_board(frame.viewport.width, frame.viewport.height);
    for_each_fragment(frame, {.normal = true}, raster::AttributeInterpolation::perspective,
                      [&](int x, int y, const raster::Fragments& f, int i) {
                          image.set_rgb(x, y, color_of_normal(glm::normalize(f.normal.at(i))));
                      });
    return image;
}

/// How many samples wide a line is; a pixel has n x n.
int line_width(const Options& options) {
    return options.samples * std::max(1, options.height / 540);
}

/// Wireframe, flat and smooth normals of a mesh.
std::vector<Image> draw_mesh(raster::Mesh mesh, const glm::mat4& world_from_object, const Options& options) {
    const int n = options.samples;
    const glm::ivec2 size = n * panel_size(options.width, options.height, 3, 2);
    const auto frame = [&] { return frame_of(mesh, world_from_object, size); };
    std::vector<Image> panels = {box_average(draw_wireframe(frame(), line_width(options)), n)};
    make_flat_normals(mesh);
    panels.push_back(box_average(draw_normals(frame()), n));
    make_smooth_normals(mesh, 60.0f);
    panels.push_back(box_average(draw_normals(frame()), n));
    return panels;
}

void draw(const Options& options) {
    const raster::Mesh gem = scene::load_mesh_file(KREDA_EXAMPLE_FOLDER "/gem.obj").mesh;
    const raster::Mesh teapot = raster::make_teapot(3);
    std::printf("gem: %zu corners, %u triangles\n", gem.positions.size(), gem.triangle_count());
    std::printf("teapot: %zu corners, %u triangles\n", teapot.positions.size(), teapot.triangle_count());

    const glm::mat4 gem_in_world = glm::scale(glm::mat4(1.0f), glm::vec3(0.3f));
    const glm::mat4 teapot_in_world =
        glm::translate(glm::mat4(1.0f), {0.0f, -0.5f, 0.0f}) * glm::scale(glm::mat4(1.0f), glm::vec3(0.95f));
    std::vector<Image> images = draw_mesh(gem, gem_in_world, options);
    const std::vector<Image> more = draw_mesh(teapot, teapot_in_world, options);
    images.insert(images.end(), more.begin(), more.end());
    save_panels(options, "normals", 3,
                with_captions(images, {"triangles", "flat normals", "smooth normals", "triangles", "flat normals",
                                       "smooth normals"}));
    const Image wireframe = averaged({options.width, options.height}, options.samples, [&](glm::ivec2 size) {
        return draw_wireframe(frame_of(teapot, teapot_in_world, size), line_width(options));
    });
    save(options, "wireframe", wireframe);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "15_mesh", draw);
}
