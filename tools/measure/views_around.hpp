// What the Fresnel methods are compared on: two objects, seen from 180 directions.   Gelemanovic 2014
#pragma once

#include <string>
#include <vector>

#include "raster/camera.hpp"
#include "raster/mesh.hpp"

namespace kreda::tools {

inline constexpr int kViewsAround = 180;

struct Subject {
    std::string name;
    raster::Mesh mesh;
};

/// A cube of side 1, and a torus knot: few large faces, and normals in all directions.
[[nodiscard]] std::vector<Subject> comparison_subjects();

/// The camera of view 0 .. 179: two units from the middle, turned about the axis (1, 1, 1) by a degree a view.
[[nodiscard]] raster::Camera comparison_camera(int view);

}  // namespace kreda::tools
