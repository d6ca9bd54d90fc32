// Every texel of a cube map in turn.
#pragma once

#include "lighting/environment/cube_map.hpp"

namespace kreda::tools {

/// Calls visit(face, x, y) for every texel of a level of `size` texels a side: face by face, row by row.
template <class Visit>
void for_each_texel(int size, Visit visit) {
    for (int face = 0; face < lighting::kCubeFaces; ++face) {
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) visit(face, x, y);
        }
    }
}

}  // namespace kreda::tools
