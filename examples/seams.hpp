// Environments as they are filtered wrongly, to be seen beside the right ones: borders that repeat the map's own
// outermost texels, as a clamped texture does, instead of those that lie beside them on the sphere.
#pragma once

#include "lighting/environment/environment_image.hpp"

namespace kreda::examples {

/// Level 0 of a cube map, every face for itself.
[[nodiscard]] lighting::CubeMap with_faces_alone(const lighting::CubeMap& map);

/// An equirectangular map that ends at the meridian and at the poles.
[[nodiscard]] lighting::EquirectMap without_wrapping(const lighting::EquirectMap& map);

}  // namespace kreda::examples
