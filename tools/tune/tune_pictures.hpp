// What tune found, as pictures.
#pragma once

#include "tools/tune/tune.hpp"

namespace kreda::tools {

/// Error over cost of all best sets, logarithmic, with pictures of some of them; the choice is marked. Linear RGB.
[[nodiscard]] raster::Image front_picture(const SceneSource& source, const Tuned& tuned, const TuneOptions& options);

/// Who spent the error where: each pixel in the colour of the term that would change it most, as bright as by how many
/// codes; 8 and more are full. A legend names the terms that spent the most. Linear RGB.
[[nodiscard]] raster::Image attribution_picture(const std::vector<Term>& terms,
                                                const std::vector<std::vector<float>>& codes, int width, int height);

}  // namespace kreda::tools
