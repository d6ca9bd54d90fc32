#include "examples/seams.hpp"

#include <algorithm>

namespace kreda::examples {

lighting::CubeMap with_faces_alone(const lighting::CubeMap& map) {
    lighting::CubeMap alone = map;
    const int size = map.levels[0].size;
    const auto inside = [&](int i) { return std::clamp(i, 0, size - 1); };
    for (int face = 0; face < lighting::kCubeFaces; ++face) {
        for (int y = -1; y <= size; ++y) {
            for (int x = -1; x <= size; ++x) {
                alone.set_texel(0, face, x, y, map.texel(0, face, inside(x), inside(y)));
            }
        }
    }
    return alone;
}

lighting::EquirectMap without_wrapping(const lighting::EquirectMap& map) {
    lighting::EquirectMap clamped = map;
    const int side = map.width + 2;
    for (int y = 0; y < map.height + 2; ++y) {
        for (int x = 0; x < side; ++x) {
            const int from = std::clamp(y, 1, map.height) * side + std::clamp(x, 1, map.width);
            std::copy_n(map.texels.begin() + 4 * from, 4, clamped.texels.begin() + 4 * (y * side + x));
        }
    }
    return clamped;
}

}  // namespace kreda::examples
