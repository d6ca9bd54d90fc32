#include "scene/extent.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "raster/clip.hpp"

namespace kreda::scene {

namespace {

/// Two triangles a side of a box, corners numbered by bits: 1 for x, 2 for y, 4 for z.
constexpr int kBoxTriangles[12][3] = {{0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}, {0, 4, 5}, {0, 5, 1},
                                      {2, 3, 7}, {2, 7, 6}, {0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}};
constexpr int kBoxEdges[12][2] = {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3},
                                  {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};

/// The sides of the box, cut off where the view ends.
void add_seen_sides(const Box& box, const glm::mat4& clip_from_world, std::vector<glm::vec3>& points) {
    const std::array<glm::vec3, 8> corner = box.corners();
    for (const int(&triangle)[3] : kBoxTriangles) {
        std::array<glm::vec4, 3> clip;
        for (int i = 0; i < 3; ++i) clip[i] = clip_from_world * glm::vec4(corner[triangle[i]], 1.0f);
        const raster::ClipPolygon polygon = raster::clip_triangle(clip[0], clip[1], clip[2], 1.0f, 1.0f);
        for (int i = 0; i < polygon.count; ++i) {
            const glm::vec3 w = polygon.vertex[i].weights;
            points.push_back(w.x * corner[triangle[0]] + w.y * corner[triangle[1]] + w.z * corner[triangle[2]]);
        }
    }
}

/// The edges of the view volume, cut off where the box ends.
void add_view_edges(const Box& box, const glm::mat4& clip_from_world, std::vector<glm::vec3>& points) {
    const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4(clip_from_world));
    std::array<glm::dvec3, 8> corner;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec4 p =
            world_from_clip * glm::dvec4(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0, 1.0);
        corner[static_cast<std::size_t>(i)] = glm::dvec3(p) / p.w;
    }
    for (const int(&edge)[2] : kBoxEdges) {
        const glm::dvec3 a = corner[edge[0]], along = corner[edge[1]] - a;
        double enter = 0.0, leave = 1.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double to_least = box.least[axis] - a[axis], to_greatest = box.greatest[axis] - a[axis];
            if (std::abs(along[axis]) < 1e-12) {
                if (to_least > 0.0 || to_greatest < 0.0) leave = -1.0;
                continue;
            }
            const double at_least = to_least / along[axis], at_greatest = to_greatest / along[axis];
            enter = std::max(enter, std::min(at_least, at_greatest));
            leave = std::min(leave, std::max(at_least, at_greatest));
        }
        if (enter > leave) continue;
        points.emplace_back(a + enter * along);
        points.emplace_back(a + leave * along);
    }
}

}  // namespace

std::array<glm::vec3, 8> Box::corners() const {
    std::array<glm::vec3, 8> corner;
    for (int i = 0; i < 8; ++i) {
        corner[static_cast<std::size_t>(i)] = {(i & 1 ? greatest : least).x, (i & 2 ? greatest : least).y,
                                               (i & 4 ? greatest : least).z};
    }
    return corner;
}

std::vector<glm::vec3> drawn_points(const Object& object) {
    const raster::Mesh& mesh = *object.mesh;
    std::vector<bool> drawn(mesh.positions.size(), false);
    for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
        if (p < object.part_hidden.size() && object.part_hidden[p]) continue;
        const std::size_t first = 3 * std::size_t{mesh.parts[p].first_triangle};
        const std::size_t count = 3 * std::size_t{mesh.parts[p].triangle_count};
        for (std::size_t i = first; i < first + count; ++i) drawn[mesh.indices[i]] = true;
    }
    std::vector<glm::vec3> points;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        if (drawn[i]) points.emplace_back(object.world_from_object * glm::vec4(mesh.positions[i], 1.0f));
    }
    return points;
}

Box box_of(const std::vector<glm::vec3>& points) {
    if (points.empty()) return {};
    Box box{points.front(), points.front()};
    for (const glm::vec3& p : points) {
        box.least = glm::min(box.least, p);
        box.greatest = glm::max(box.greatest, p);
    }
    return box;
}

std::vector<glm::vec3> seen_corners(const Box& box, const Scene& scene) {
    const float aspect = raster::aspect_of(scene.image.width, scene.image.height);
    const glm::mat4 clip = raster::clip_from_world(scene.camera, aspect);
    std::vector<glm::vec3> points;
    add_seen_sides(box, clip, points);
    add_view_edges(box, clip, points);
    return points;
}

std::optional<Plane> common_plane(const std::vector<glm::vec3>& points) {
    if (points.size() < 3) return std::nullopt;
    const glm::dvec3 origin(points.front());
    const auto farthest_by = [&](auto measure) {
        return *std::max_element(points.begin(), points.end(), [&](const glm::vec3& a, const glm::vec3& b) {
            return measure(glm::dvec3(a) - origin) < measure(glm::dvec3(b) - origin);
        });
    };
    const auto length = [](const glm::dvec3& v) { return glm::dot(v, v); };
    const glm::dvec3 s = glm::dvec3(farthest_by(length)) - origin;
    const auto area = [&](const glm::dvec3& v) { return length(glm::cross(s, v)); };
    const glm::dvec3 across = glm::cross(s, glm::dvec3(farthest_by(area)) - origin);
    if (length(across) <= 1e-24 * length(s) * length(s)) return std::nullopt;  // all on a line
    const glm::dvec3 normal = glm::normalize(across);
    const double tolerance = 1e-5 * std::sqrt(length(s));
    for (const glm::vec3& p : points) {
        if (std::abs(glm::dot(normal, glm::dvec3(p) - origin)) > tolerance) return std::nullopt;
    }
    return Plane{glm::vec3(normal), static_cast<float>(glm::dot(normal, origin))};
}

}  // namespace kreda::scene
