#include "raster/camera.hpp"

#include <cmath>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace kreda::raster {

ViewAxes view_axes(const glm::dvec3& forward, const glm::dvec3& up_hint) {
    const glm::dvec3 right = glm::normalize(glm::cross(forward, up_hint));
    return {right, glm::cross(right, forward), forward};
}

ViewAxes view_axes(const Camera& camera) {
    return view_axes(glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.position)), glm::dvec3(camera.up));
}

glm::mat4 view_from_world(const Camera& camera) {
    const ViewAxes axes = view_axes(camera);
    const glm::dvec3 eye(camera.position);
    const glm::dvec3 moved{-glm::dot(axes.right, eye), -glm::dot(axes.up, eye), glm::dot(axes.forward, eye)};
    glm::dmat4 view_from_world(glm::transpose(glm::dmat3(axes.right, axes.up, -axes.forward)));
    view_from_world[3] = glm::dvec4(moved, 1.0);
    return glm::mat4(view_from_world);
}

glm::mat4 clip_from_view(const Camera& camera, float aspect) {
    if (camera.projection == Projection::perspective) {
        const double fov_y = glm::radians(double{camera.vertical_fov_deg});
        return glm::mat4(glm::perspectiveRH_NO(fov_y, double{aspect}, double{camera.near}, double{camera.far}));
    }
    const double half_height = 0.5 * camera.height;
    const double half_width = half_height * aspect;
    return glm::mat4(
        glm::orthoRH_NO(-half_width, half_width, -half_height, half_height, double{camera.near}, double{camera.far}));
}

glm::mat4 clip_from_world(const Camera& camera, float aspect) {
    return clip_from_view(camera, aspect) * view_from_world(camera);
}

glm::vec3 view_direction(const Camera& camera) {
    return glm::vec3(view_axes(camera).forward);
}

}  // namespace kreda::raster
