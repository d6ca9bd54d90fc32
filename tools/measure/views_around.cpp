#include "tools/measure/views_around.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "raster/shapes.hpp"

namespace kreda::tools {

namespace {

raster::Mesh scaled(raster::Mesh mesh, float factor) {
    for (glm::vec3& position : mesh.positions) position *= factor;
    return mesh;
}

}  // namespace

std::vector<Subject> comparison_subjects() {
    return {{"cube", scaled(raster::make_cube(1), 0.5f)}, {"knot", scaled(raster::make_torus_knot(384), 0.55f)}};
}

raster::Camera comparison_camera(int view) {
    const glm::dvec3 start(0.0, 0.0, -2.0);
    const glm::dvec3 axis = glm::normalize(glm::dvec3(1.0));
    const double angle = view * std::numbers::pi / 180.0;
    raster::Camera camera;
    camera.position = start * std::cos(angle) + glm::cross(axis, start) * std::sin(angle) +
                      axis * glm::dot(axis, start) * (1.0 - std::cos(angle));  // Rodrigues 1840
    camera.up = axis;
    camera.vertical_fov_deg = 60.0f;
    return camera;
}

}  // namespace kreda::tools
