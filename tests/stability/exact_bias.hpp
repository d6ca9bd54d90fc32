// The shadow map that the formulas of shadows/map_point.hpp are tried with.
#pragma once

#include <algorithm>
#include <cmath>

#include "shadows/map_point.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

/// A cosine that is at least 0.01 from 0.
inline Real limited(Real cosine) {
    const Real size = std::max(std::fabs(cosine), Real(shadows::kLeastCosine));
    return cosine < 0 ? -size : size;
}

/// A picture of 90 degrees with 1024 texels a side, and the bias that follows the slope.
inline const shadows::PictureScale kPicture{glm::vec2(2.0f / 1024.0f), glm::vec2(512.0f), 512.0f};
inline const shadows::BiasTerms kSlopeBias{1e-3f, 1.0f, 0.0f, 1.0f};

}  // namespace kreda::tests
