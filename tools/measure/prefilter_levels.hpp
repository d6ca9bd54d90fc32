// One level of a prefiltered map, made on its own: from as many samples as one likes, or from every texel.
#pragma once

#include "lighting/environment/prefilter.hpp"

namespace kreda::tools {

/// prefiltered_radiance() for every texel of a level of size x size texels a face.
[[nodiscard]] lighting::CubeMap sampled_level(const lighting::CubeMap& radiance, float alpha, int samples, int size);

/// The integral without sampling:  sum of L w D(h) (n.l) / sum of w D(h) (n.l)  over all texels of level 0.
[[nodiscard]] lighting::CubeMap exact_level(const lighting::CubeMap& radiance, float alpha, int size);

/// The environment without its mip levels: what reads it finds single texels.
[[nodiscard]] lighting::CubeMap without_mips(lighting::CubeMap radiance);

}  // namespace kreda::tools
