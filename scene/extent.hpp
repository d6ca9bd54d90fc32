// How far objects reach in the world, and which part of that the camera sees.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.hpp"

namespace kreda::scene {

/// A box along the axes of the world.
struct Box {
    glm::vec3 least{0.0f}, greatest{0.0f};

    [[nodiscard]] std::array<glm::vec3, 8> corners() const;
};

/// The corners of all drawn triangles of an object, world space, some of them several times.
[[nodiscard]] std::vector<glm::vec3> drawn_points(const Object& object);

[[nodiscard]] Box box_of(const std::vector<glm::vec3>& points);

/// Corners of the part of the box that lies in the camera's view; empty: nothing does.
[[nodiscard]] std::vector<glm::vec3> seen_corners(const Box& box, const Scene& scene);

/// Points p with dot(normal, p) = offset.
struct Plane {
    glm::vec3 normal{0.0f, 1.0f, 0.0f};  ///< unit
    float offset = 0.0f;
};

/// The plane in which all the points lie, if there is one.
[[nodiscard]] std::optional<Plane> common_plane(const std::vector<glm::vec3>& points);

}  // namespace kreda::scene
