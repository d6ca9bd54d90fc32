// From the places of a scene file, in double, to those of the scene, in float and from an origin near what is seen.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "scene/error.hpp"
#include "scene/scene.hpp"

namespace kreda::scene {

/// Where a light is.
struct LightPlacement {
    glm::dvec3 position{0.0};  ///< world space
    Place place;               ///< in the file
};

/// How an object is placed: scale, then turn, then move.
struct ObjectPlacement {
    glm::dvec3 translate{0.0};
    glm::dvec3 rotate_deg{0.0};
    glm::dvec3 scale{1.0};
    Place place, scale_place;  ///< in the file
};

/// What the file says in double; one entry for each of the scene's lights and objects.
struct Placements {
    glm::dvec3 camera_position{0.0};  ///< world space
    glm::dvec3 camera_target{0.0};    ///< world space
    std::vector<LightPlacement> lights;
    std::vector<ObjectPlacement> objects;
};

/// Set scene.origin and everything in the scene that has a place. Throws UserError for what is too far from the camera,
/// too large or too small for float.
void place_scene(const Placements& placements, Scene& scene);

}  // namespace kreda::scene
