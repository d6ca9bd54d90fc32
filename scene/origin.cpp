#include "scene/origin.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace kreda::scene {

namespace {

double largest(const glm::dvec3& v) {
    const glm::dvec3 size = glm::abs(v);
    return std::max({size.x, size.y, size.z});
}

/// The height of the picture in the world at a distance from the camera.
double seen_height(const raster::Camera& lens, double distance) {
    if (lens.projection == raster::Projection::orthographic) return lens.height;
    return 2.0 * std::max(distance, double{lens.near}) * std::tan(0.5 * glm::radians(double{lens.vertical_fov_deg}));
}

/// The point of the ball that is nearest to the camera, and the height of the picture there.
struct NearestPoint {
    glm::dvec3 point;
    double height = 1.0;
};

NearestPoint nearest_point(const CameraPlace& camera, const ObjectPlace& object) {
    const glm::dvec3 to_camera = camera.position - object.middle;
    const double distance = glm::length(to_camera);
    if (distance <= object.radius) return {camera.position, seen_height(camera.lens, 0.0)};
    return {object.middle + to_camera * (object.radius / distance), seen_height(camera.lens, distance - object.radius)};
}

double object_loss(const glm::dvec3& origin, const CameraPlace& camera, const ObjectPlace& object) {
    const NearestPoint nearest = nearest_point(camera, object);
    return largest(nearest.point - origin) / nearest.height;
}

/// Position and target say where the camera looks.
double camera_loss(const glm::dvec3& origin, const CameraPlace& camera) {
    return std::max(largest(camera.position - origin), largest(camera.target - origin)) /
           glm::length(camera.target - camera.position);
}

/// A power of two as large as what is seen of the objects where it is smallest.
double step_near(const CameraPlace& camera, const std::vector<ObjectPlace>& objects) {
    double least = glm::length(camera.target - camera.position);
    for (const ObjectPlace& object : objects) least = std::min(least, nearest_point(camera, object).height);
    return std::exp2(std::floor(std::log2(least)));
}

}  // namespace

double loss_about(const glm::dvec3& origin, const CameraPlace& camera, const std::vector<ObjectPlace>& objects) {
    double loss = camera_loss(origin, camera);
    for (const ObjectPlace& object : objects) loss = std::max(loss, object_loss(origin, camera, object));
    return loss;
}

glm::dvec3 choose_origin(const CameraPlace& camera, const std::vector<ObjectPlace>& objects) {
    glm::dvec3 best(0.0);
    double least = loss_about(best, camera, objects);
    if (least <= kGreatestLoss) return best;
    const double step = step_near(camera, objects);
    std::vector<glm::dvec3> candidates{camera.position, camera.target};
    const auto worst = std::max_element(objects.begin(), objects.end(), [&](const auto& a, const auto& b) {
        return object_loss(glm::dvec3(0.0), camera, a) < object_loss(glm::dvec3(0.0), camera, b);
    });
    if (worst != objects.end()) candidates.push_back(worst->middle);
    for (const glm::dvec3& candidate : candidates) {
        const glm::dvec3 rounded = glm::round(candidate / step) * step;
        const double loss = loss_about(rounded, camera, objects);
        if (loss >= 0.5 * least) continue;
        best = rounded;
        least = loss;
    }
    return best;
}

double lost_in_double(const CameraPlace& camera, const std::vector<ObjectPlace>& objects) {
    return loss_about(glm::dvec3(0.0), camera, objects) * std::exp2(-53.0);
}

}  // namespace kreda::scene
