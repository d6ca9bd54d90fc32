// Whether a light can reach any point of a triangle.
#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "lighting/light.hpp"

namespace kreda::scene {

/// The corners of a triangle, world space, and what its normals may be.
struct LitTriangle {
    std::array<glm::vec3, 3> position;
    std::array<glm::vec3, 3> normal;  ///< any length
    bool any_normal = false;          ///< a map bends them, or the side that is seen is not known
};

/// False: it sends nothing to any point of the triangle, or shines on the back of all. True where that is not certain.
[[nodiscard]] bool may_reach(const lighting::LightSetup& light, const LitTriangle& triangle);

}  // namespace kreda::scene
