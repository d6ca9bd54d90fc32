// Fresnel's F on pictures: an object seen from 180 directions, painted by one method and by the exact one, compared.
#pragma once

#include <string>
#include <vector>

#include "examples/draw.hpp"
#include "examples/fresnel_methods.hpp"
#include "raster/camera.hpp"
#include "raster/mesh.hpp"

namespace kreda::examples {

struct Subject {
    std::string name;
    raster::Mesh mesh;
};

/// A cube of side 1, and a torus knot: few large faces, and normals in all directions.
[[nodiscard]] std::vector<Subject> comparison_subjects();

/// The camera of view 0 .. 179: two units from the middle, turned about the axis (1, 1, 1) by a degree a view.
[[nodiscard]] raster::Camera comparison_camera(int view);

/// The cosines n.v of every pixel of 180 views that sees the object.
[[nodiscard]] std::vector<float> cosines_of_views(const raster::Mesh& mesh, glm::ivec2 size);

/// Append four panels: F exact, F by Schlick, the mask of what is compared, and the relative difference `gain` times as
/// bright.
void add_comparison(const Subject& subject, glm::ivec2 size, int picture_height,
                    const lighting::ThreeChannelIndex& index, float gain, std::vector<Image>& panels);

/// Mean relative error over all pixels of 180 views of each subject, for each method and material, as a table on
/// stdout.
void print_picture_errors();

}  // namespace kreda::examples
