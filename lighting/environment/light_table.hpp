// Where an environment's light comes from: a table by which directions are chosen as often as they are bright.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lighting/environment/cube_map.hpp"

namespace kreda::lighting {

/// A texel (x, y) of a face is chosen with the probability
///   P = w / sum of w,   w = luminance x solid angle
/// in two steps, first its row of all six faces, then its column (a CDF each, built once), and a point within it
/// evenly. The luminance is that of the bilinear look-up's mean over the texel, so that no direction with light is left
/// out.
struct LightTable {
    int size = 0;                   ///< texels a side
    std::vector<float> row_end;     ///< 6 size numbers: probability of this row or one before it; the last is 1
    std::vector<float> column_end;  ///< size numbers a row: the same for the columns of that row
    std::vector<float> density;     ///< P size^2 / 4, face by face, row by row: see light_density()
};

/// The table of level 0. Black everywhere: every direction is as likely as its texel is large.
[[nodiscard]] LightTable make_light_table(const CubeMap& map);

/// The direction for a point of the unit square, unit, as the map knows it.
[[nodiscard]] glm::vec3 choose_light(const LightTable& table, const glm::vec2& u);

/// Where the density of a direction stands in the table, and what it is multiplied by: |d|^3.
struct DensityTap {
    std::int32_t texel;  ///< its place in the table
    float factor;        ///< |d|^3, d the direction scaled to touch the cube
};

/// Where a unit direction lies on the faces of `size` texels a side.
inline DensityTap density_tap(int size, const glm::vec3& direction) {
    const CubePoint point = cube_point(direction);
    const int x = static_cast<int>(point.u * static_cast<float>(size));
    const int y = static_cast<int>(point.v * static_cast<float>(size));
    const int column = x < size ? x : size - 1;
    const int row = y < size ? y : size - 1;
    const float s = 2.0f * point.u - 1.0f;
    const float t = 2.0f * point.v - 1.0f;
    const float length2 = 1.0f + s * s + t * t;
    return {(point.face * size + row) * size + column, length2 * std::sqrt(length2)};
}

/// With which density a direction is chosen [1/sr]   p = P size^2 |d|^3 / 4,   d scaled to touch the cube: a square
/// du dv on a face is seen under the solid angle 4 du dv / |d|^3.   direction: of any length, as the map knows it
inline float light_density(const LightTable& table, const glm::vec3& direction) {
    const DensityTap tap = density_tap(table.size, direction);
    return table.density[static_cast<std::size_t>(tap.texel)] * tap.factor;
}

}  // namespace kreda::lighting
