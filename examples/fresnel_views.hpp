// Fresnel's F on pictures: an object seen from 180 directions, painted by one method and by the exact one, compared.
#pragma once

#include <string>
#include <vector>

#include "examples/panel.hpp"
#include "tools/measure/fresnel_methods.hpp"
#include "tools/measure/views_around.hpp"

namespace kreda::examples {

using tools::comparison_camera, tools::comparison_subjects, tools::Subject;
using tools::exact_fresnel, tools::fresnel_curves, tools::FresnelCurve, tools::mean_errors_percent;

/// The cosines n.v of every pixel of 180 views that sees the object.
[[nodiscard]] std::vector<float> cosines_of_views(const raster::Mesh& mesh, glm::ivec2 size);

/// Append four panels: F exact, F by Schlick, the mask of what is compared, and the relative difference `gain` times as
/// bright.
void add_comparison(const Subject& subject, glm::ivec2 size, const lighting::ThreeChannelIndex& index, float gain,
                    std::vector<Panel>& panels);

/// Mean relative error over all pixels of 180 views of each subject, for each method and material, as a table on
/// stdout.
void print_picture_errors();

}  // namespace kreda::examples
