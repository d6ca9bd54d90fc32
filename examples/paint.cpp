#include "examples/paint.hpp"

#include <glm/geometric.hpp>

#include "examples/fragment_loop.hpp"

namespace kreda::examples {

void for_each_surface_point(const raster::Mesh& mesh, const raster::Camera& camera, glm::ivec2 size,
                            const std::function<void(int, int, const SurfacePoint&)>& visit) {
    raster::MeshInstance instance;
    instance.mesh = &mesh;
    instance.part_material.assign(mesh.parts.size(), 0);
    const glm::mat4 clip = raster::clip_from_world(camera, raster::aspect_of(size.x, size.y));
    const FrameGeometry frame =
        make_frame_geometry({instance}, clip, {size.x, size.y}, {.position_world = true, .normal_world = true});
    for_each_fragment(frame, {.position = true, .normal = true}, raster::AttributeInterpolation::perspective,
                      [&](int x, int y, const raster::Fragments& f, int i) {
                          const glm::vec3 p = f.position.at(i);
                          const glm::vec3 v = camera.projection == raster::Projection::orthographic
                                                  ? -raster::view_direction(camera)
                                                  : glm::normalize(camera.position - p);
                          visit(x, y, {p, glm::normalize(f.normal.at(i)), v});
                      });
}

Image paint(const raster::Mesh& mesh, const raster::Camera& camera, glm::ivec2 size, int samples,
            const glm::vec3& background, const SurfaceColor& color) {
    Image fine = make_board(size.x * samples, size.y * samples, background);
    for_each_surface_point(mesh, camera, {fine.width, fine.height},
                           [&](int x, int y, const SurfacePoint& point) { fine.set_rgb(x, y, color(point)); });
    return box_average(fine, samples);
}

}  // namespace kreda::examples
