// Pictures of what lies in every direction: unrolled into an equirectangular image, unfolded into the six faces of a
// cube, or seen by a camera. A pixel is the mean of 2 x 2 directions.
#pragma once

#include <functional>

#include "examples/panel.hpp"

namespace kreda::examples {

/// A colour for a unit direction, world space.
using DirectionColor = std::function<glm::vec3(const glm::vec3&)>;

/// width x width / 2 pixels: +x in the middle, +y on top, as lighting/environment/environment_image.hpp lays it out.
[[nodiscard]] Image equirect_picture(int width, const DirectionColor& color);

/// The faces as lighting/environment/cube_map.hpp numbers them, side x side pixels each, in a cross of 4 x 3 whose
/// neighbours touch: +y on top, -x +z +x -z in the middle, -y below. Seen from outside, so left and right are those of
/// a mirror.
[[nodiscard]] Image cube_picture(int side, const DirectionColor& color);

/// The same pictures with the axes' names written where they lie.
[[nodiscard]] Panel with_equirect_axes(Image picture, float type_size);
[[nodiscard]] Panel with_cube_axes(Image picture, float type_size);

/// What a camera in the middle sees that looks along `forward` (any length, not straight up or down).
[[nodiscard]] Image camera_picture(glm::ivec2 size, const glm::vec3& forward, float vertical_fov_deg,
                                   const DirectionColor& color);

}  // namespace kreda::examples
