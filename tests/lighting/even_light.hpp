// A cube map of the same light from everywhere, with all its mip levels.
#pragma once

#include "lighting/environment/cube_map.hpp"

namespace kreda::tests {

inline lighting::CubeMap even_light(int size, const glm::vec3& L) {
    lighting::CubeMap map = lighting::make_cube_map(lighting::mip_sizes(size));
    for (int i = 0; i < lighting::kCubeFaces * size * size; ++i) {
        map.set_texel(0, i / (size * size), i % size, i / size % size, L);
    }
    fill_border(map, 0);
    fill_mip_levels(map);
    return map;
}

}  // namespace kreda::tests
