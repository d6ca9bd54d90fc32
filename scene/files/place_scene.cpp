#include "scene/files/place_scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "scene/files/read_objects.hpp"
#include "scene/origin.hpp"

namespace kreda::scene {

namespace {

constexpr double kFarthestSeen = 2e9;  ///< a product of four such numbers is still a finite float
constexpr double kLeastScale = 1e-9;

std::string text_of(double number) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.3g", number);
    return buffer;
}

/// A ball around the positions of a mesh, in its own unit and from its own origin.
ObjectPlace ball_around(const raster::Mesh& mesh) {
    if (mesh.positions.empty()) return {};
    glm::dvec3 least(mesh.positions.front()), greatest = least;
    for (const glm::vec3& p : mesh.positions) {
        least = glm::min(least, glm::dvec3(p));
        greatest = glm::max(greatest, glm::dvec3(p));
    }
    return {0.5 * (least + greatest), 0.5 * glm::length(greatest - least)};
}

/// The world <- object transform in double.
struct Transform {
    glm::dmat3 linear{1.0};  ///< the mesh's unit included
    glm::dvec3 moved{0.0};   ///< where the mesh's origin comes to lie, world space
    double largest_scale = 1.0;
};

Transform transform_of(const ObjectPlacement& placement, const raster::Mesh& mesh) {
    const glm::dmat3 linear(placed(placement.translate, placement.rotate_deg, placement.scale));
    const glm::dvec3 scale = glm::abs(placement.scale);
    return {linear * mesh.unit, placement.translate + linear * mesh.origin,
            std::max({scale.x, scale.y, scale.z}) * mesh.unit};
}

void check_far(const glm::dvec3& p, const glm::dvec3& eye, const Place& place, const std::string& what) {
    const glm::dvec3 d = glm::abs(p - eye);
    if (std::max({d.x, d.y, d.z}) <= kFarthestSeen) return;
    throw UserError(place, what + " is " + text_of(glm::length(p - eye)) +
                               " away from where the picture is computed (near the camera); beyond 1e9 nothing is "
                               "drawn: move it or the camera");
}

/// Scale is checked together with the mesh's unit: a mesh of 1e30 is drawn with a scale of 1e-30.
void check_size(const raster::Mesh& mesh, const Transform& transform, double radius, const std::string& name,
                const ObjectPlacement& placement) {
    const glm::dvec3 scale = glm::abs(placement.scale) * mesh.unit;
    const bool flat = std::min({scale.x, scale.y, scale.z}) < kLeastScale;
    if (mesh.unit == 1.0 && flat) {
        throw UserError(placement.scale_place, "'scale' in [[object]] must not be 0: it would flatten the object");
    }
    const double in_world = radius * transform.largest_scale;
    if (!flat && in_world <= kFarthestSeen) return;
    throw UserError(placement.scale_place, "the mesh '" + name + "' would have a radius of " + text_of(in_world) +
                                               " in the world; draw it with a scale of about " +
                                               text_of(1.0 / mesh.unit));
}

/// With nothing far away these are the same bits as world_from_object(): rounded once, from the same numbers.
glm::mat4 matrix_of(const ObjectPlacement& placement, const raster::Mesh& mesh, const Transform& transform,
                    const glm::dvec3& origin) {
    glm::mat4 matrix = world_from_object(glm::vec3(placement.translate), glm::vec3(placement.rotate_deg),
                                         mesh.unit == 1.0 ? glm::vec3(placement.scale) : glm::vec3(1.0f));
    if (mesh.unit != 1.0) matrix = glm::mat4(glm::mat3(transform.linear));
    matrix[3] = glm::vec4(glm::vec3(transform.moved - origin), 1.0f);
    return matrix;
}

void warn_of_double(const CameraPlace& camera, const std::vector<ObjectPlace>& objects, Scene& scene) {
    constexpr double kVisible = 1.0 / 4096.0;
    const double lost = lost_in_double(camera, objects);
    if (lost < kVisible) return;
    scene.warnings.push_back(scene.file + ": places are written with 16 digits, and so far from 0 that they are " +
                             "rounded to " + text_of(lost) +
                             " of the picture's height; move the scene nearer to [0, 0, 0]");
}

}  // namespace

void place_scene(const Placements& placements, Scene& scene) {
    const CameraPlace camera{placements.camera_position, placements.camera_target, scene.camera};
    std::map<const raster::Mesh*, ObjectPlace> balls;
    std::vector<Transform> transforms;
    std::vector<ObjectPlace> objects;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const raster::Mesh& mesh = *scene.objects[i].mesh;
        const auto [ball, is_new] = balls.try_emplace(&mesh);
        if (is_new) ball->second = ball_around(mesh);
        const Transform& transform = transforms.emplace_back(transform_of(placements.objects[i], mesh));
        check_size(mesh, transform, ball->second.radius, scene.objects[i].mesh_name, placements.objects[i]);
        objects.push_back(
            {transform.moved + transform.linear * ball->second.middle, ball->second.radius * transform.largest_scale});
    }
    const glm::dvec3 origin = choose_origin(camera, objects);
    scene.origin = origin;
    scene.camera.position = glm::vec3(camera.position - origin);
    scene.camera.target = glm::vec3(camera.target - origin);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const LightPlacement& light = placements.lights[i];
        if (scene.lights[i].type != lighting::LightType::directional)
            check_far(light.position, origin, light.place, "this light");
        scene.lights[i].position = glm::vec3(light.position - origin);
    }
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const ObjectPlacement& object = placements.objects[i];
        check_far(transforms[i].moved, origin, object.place, "this object");
        scene.objects[i].world_from_object = matrix_of(object, *scene.objects[i].mesh, transforms[i], origin);
    }
    warn_of_double(camera, objects, scene);
}

}  // namespace kreda::scene
