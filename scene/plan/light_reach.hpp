// Whether a light can reach any point of a triangle, or one point.
#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "lighting/light.hpp"

namespace kreda::scene {

/// The corners of a triangle, world space, and what its normals may be.
struct LitTriangle {
    std::array<glm::vec3, 3> position;
    std::array<glm::vec3, 3> normal;  ///< any length
    bool any_normal = false;          ///< a map bends them
};

/// False: it sends nothing to any point of the triangle, or shines on the back of all. True where that is not certain.
[[nodiscard]] bool may_reach(const lighting::LightSetup& light, const LitTriangle& triangle);

/// The same for one point p with normal n (any length), where nothing is interpolated: light arrives, and n faces it.
[[nodiscard]] bool reaches_point(const lighting::LightSetup& light, const glm::vec3& p, const glm::vec3& n,
                                 bool any_normal);

}  // namespace kreda::scene
