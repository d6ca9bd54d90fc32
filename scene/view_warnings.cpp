#include "scene/view_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

#include <glm/geometric.hpp>

#include "scene/extent.hpp"

namespace kreda::scene {

namespace {

std::string text_of(double number) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.3g", number);
    return buffer;
}

/// Where an object lies along the view direction, counted from the camera, and its size.
struct DepthRange {
    double least = std::numeric_limits<double>::max();
    double greatest = -std::numeric_limits<double>::max();
    double radius = 0.0;
};

DepthRange join(const DepthRange& a, const DepthRange& b) {
    return {std::min(a.least, b.least), std::max(a.greatest, b.greatest), std::max(a.radius, b.radius)};
}

DepthRange depth_range(const Scene& scene, const Object& object, const Box& box) {
    const glm::dvec3 eye(scene.camera.position);
    const glm::dvec3 forward = glm::normalize(glm::dvec3(scene.camera.target) - eye);
    DepthRange range;
    glm::dvec3 first(0.0), last(0.0);
    const std::array<glm::vec3, 8> corners = box.corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 p(glm::dmat4(object.world_from_object) * glm::dvec4(corners[i], 1.0));
        const double depth = glm::dot(p - eye, forward);
        range.least = std::min(range.least, depth);
        range.greatest = std::max(range.greatest, depth);
        if (i == 0) first = p;
        if (i == 7) last = p;
    }
    range.radius = 0.5 * glm::length(last - first);
    return range;
}

/// Two digits, rounded down: a near plane that cuts nothing off.
double round_down(double x) {
    const double step = std::pow(10.0, std::floor(std::log10(x)) - 1.0);
    return std::floor(x / step) * step;
}

/// An object needs some 32 depths from middle to front, and none finer than what a pixel shows.
bool has_too_few_depths(const raster::Camera& camera, const DepthRange& range) {
    constexpr double kDepths = 32.0, kPixels = 64.0;
    const double z = 0.5 * (range.least + range.greatest);
    if (z <= camera.near || z >= camera.far) return false;
    return depth_step_at(camera, z) > std::max(range.radius, z / kPixels) / kDepths;
}

std::string few_depths(const raster::Camera& camera, const DepthRange& object, const DepthRange& all) {
    const double z = 0.5 * (object.least + object.greatest);
    std::string sentence = "camera.near = " + text_of(camera.near) + " and far = " + text_of(camera.far) +
                           " leave depths in steps of " + text_of(depth_step_at(camera, z)) + " where an object of " +
                           text_of(2.0 * object.radius) + " lies: hidden surfaces show through";
    raster::Camera better = camera;
    better.near = std::max(camera.near, static_cast<float>(round_down(0.9 * std::max(all.least, 1e-3 * z))));
    better.far = std::min(camera.far, static_cast<float>(1.1 * all.greatest));
    return sentence + "; try near = " + text_of(better.near) + ", far = " + text_of(better.far);
}

std::string nothing_seen(const raster::Camera& camera, const DepthRange& all) {
    if (all.greatest <= 0.0) return "everything lies behind the camera; turn it with camera.target";
    if (all.greatest < camera.near) {
        return "everything lies before camera.near = " + text_of(camera.near) + ", at most " + text_of(all.greatest) +
               " away: the picture is empty";
    }
    if (all.least > camera.far) {
        return "everything lies beyond camera.far = " + text_of(camera.far) + ", at least " + text_of(all.least) +
               " away: the picture is empty; try far = " + text_of(1.1 * all.greatest);
    }
    return "";
}

std::string point_text(const glm::dvec3& p) {
    return "[" + text_of(p.x) + ", " + text_of(p.y) + ", " + text_of(p.z) + "]";
}

/// Where everything lies to the side of what the camera sees: how to look at it.
std::string all_beside(const Scene& scene, const std::map<const raster::Mesh*, Box>& boxes) {
    std::vector<glm::vec3> corners;
    for (const Object& object : scene.objects) {
        std::vector<glm::vec3> of_object;
        for (const glm::vec3& corner : boxes.at(object.mesh.get()).corners()) {
            of_object.emplace_back(object.world_from_object * glm::vec4(corner, 1.0f));
        }
        const Box box = box_of(of_object);
        if (!seen_corners(box, scene).empty()) return "";
        corners.insert(corners.end(), {box.least, box.greatest});
    }
    const Box all = box_of(corners);
    const glm::dvec3 middle = scene.origin + 0.5 * (glm::dvec3(all.least) + glm::dvec3(all.greatest));
    return "everything lies beside what the camera sees: the picture is empty; its middle is at camera.target = " +
           point_text(middle);
}

}  // namespace

double depth_step_at(const raster::Camera& camera, double distance) {
    const double n = camera.near, f = camera.far;
    const double slope =
        camera.projection == raster::Projection::orthographic ? 1.0 / (f - n) : f * n / (distance * distance * (f - n));
    return std::exp2(-24.0) / slope;
}

std::vector<std::string> view_warnings(const Scene& scene) {
    if (scene.objects.empty()) return {};
    std::map<const raster::Mesh*, Box> boxes;
    DepthRange all;
    std::vector<DepthRange> ranges;
    for (const Object& object : scene.objects) {
        const auto [box, is_new] = boxes.try_emplace(object.mesh.get());
        if (is_new) box->second = box_of(object.mesh->positions);
        ranges.push_back(depth_range(scene, object, box->second));
        all = join(all, ranges.back());
    }
    std::string nothing = nothing_seen(scene.camera, all);
    if (nothing.empty()) nothing = all_beside(scene, boxes);
    if (!nothing.empty()) return {nothing};
    for (const DepthRange& range : ranges) {
        if (has_too_few_depths(scene.camera, range)) return {few_depths(scene.camera, range, all)};
    }
    return {};
}

}  // namespace kreda::scene
