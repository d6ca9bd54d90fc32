#include "raster/camera.hpp"

#include <cmath>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

namespace kreda::raster {

glm::mat4 view_from_world(const Camera& camera) {
    return glm::mat4(glm::lookAtRH(glm::dvec3(camera.position), glm::dvec3(camera.target), glm::dvec3(camera.up)));
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
    return glm::vec3(glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.position)));
}

}  // namespace kreda::raster
