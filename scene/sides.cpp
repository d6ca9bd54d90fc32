#include "scene/sides.hpp"

#include <cmath>

#include <glm/geometric.hpp>

namespace kreda::scene {

namespace {

/// Cosine from which on a normal that contradicts the winding clearly points to the viewer, or away from it: about 75
/// degrees. Normals near an outline are at right angles to the view and may lean away a little.
constexpr float kClearCosine = 0.25f;

/// Directions from a point to the viewer.
glm::vec3 to_viewer(const Viewer& viewer, const glm::vec3& point) {
    return viewer.orthographic ? -viewer.forward : viewer.eye - point;
}

}  // namespace

bool seen_from_behind(bool behind, const glm::vec3& front_normal, const glm::vec3& normal, const glm::vec3& to_viewer) {
    if (glm::dot(normal, front_normal) >= 0.0f) return behind;
    const float n_dot_v = glm::dot(normal, to_viewer);
    const float clear = kClearCosine * std::sqrt(glm::dot(normal, normal) * glm::dot(to_viewer, to_viewer));
    if (std::abs(n_dot_v) > clear) return n_dot_v < 0.0f;
    return !behind;
}

/// The three corners of a drawn triangle are clockwise on the screen, so their cross product points away from the
/// viewer: to the triangle's front where its back is seen.
bool judge_side(const raster::VertexStreams& streams, const Viewer& viewer, const raster::ScreenTriangle& triangle) {
    const auto& [a, b, c] = triangle.vertex;
    const glm::vec3 p = streams.position_world[a];
    const glm::vec3 away = glm::cross(streams.position_world[b] - p, streams.position_world[c] - p);
    const glm::vec3 normal = streams.normal_world[a] + streams.normal_world[b] + streams.normal_world[c];
    const bool behind = triangle.behind != 0;
    return seen_from_behind(behind, behind ? away : -away, normal, to_viewer(viewer, p));
}

}  // namespace kreda::scene
