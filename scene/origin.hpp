// The point of the world that a frame computes from. Scene files are read in double; a frame computes in float, and a
// float has 7 digits: far from 0 they would not be enough for what the camera sees close by.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "raster/camera.hpp"

namespace kreda::scene {

/// A camera's places before an origin is subtracted, world space.
struct CameraPlace {
    glm::dvec3 position{0.0};
    glm::dvec3 target{0.0};
    raster::Camera lens;  ///< projection, angle, height, near; its position and target are not used
};

/// A ball around an object, world space.
struct ObjectPlace {
    glm::dvec3 middle{0.0};
    double radius = 0.0;
};

/// How large the places are, counted from an origin, against what the picture shows from its bottom to its top where
/// they are. Float's steps are 2^-24 of it: at 1024, in a picture of 1000 rows, a sixteenth of a pixel.
[[nodiscard]] double loss_about(const glm::dvec3& origin, const CameraPlace& camera,
                                const std::vector<ObjectPlace>& objects);

constexpr double kGreatestLoss = 1024.0;

/// 0 if that loses nothing that could be seen; else the best of the camera, its target and the middle of the object
/// that suffers most, rounded to a power of two as large as what is seen there.
[[nodiscard]] glm::dvec3 choose_origin(const CameraPlace& camera, const std::vector<ObjectPlace>& objects);

/// The same for the steps of double, which no origin can mend: the share of the picture's height that numbers as large
/// as these are rounded to.
[[nodiscard]] double lost_in_double(const CameraPlace& camera, const std::vector<ObjectPlace>& objects);

}  // namespace kreda::scene
