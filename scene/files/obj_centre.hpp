// A float has 7 digits. A mesh far from 0 would spend them on where it is; about a centre of its own they go into its
// shape.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "scene/files/obj_scan.hpp"

namespace kreda::scene {

/// Object space point = origin + unit * position.
struct MeshFrame {
    glm::dvec3 origin{0.0};
    double unit = 1.0;  ///< a power of two
};

/// Meshes whose middle is nearer to 0 than this many times their radius stay as they are.
constexpr double kFarFromZero = 16.0;
/// Meshes of a radius between 1 / this and this keep the unit 1.
constexpr double kOrdinaryRadius = 1048576.0;

/// The scan's positions as floats. Where those of the faces are far from 0 for their size, tiny or huge: about their
/// middle, in a unit of about their radius.
MeshFrame keep_about_centre(const ObjScan& scan, std::vector<glm::vec3>& positions);

}  // namespace kreda::scene
