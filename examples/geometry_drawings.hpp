// What the lectures draw on the board: where light goes. In chalk, computed from the formulas that the pages show.
#pragma once

#include "examples/example.hpp"

namespace kreda::examples {

/// Grooves of a rough surface and one mirror in them: lit and seen; in shadow; lit, and what it reflects is caught.
[[nodiscard]] std::vector<Panel> shadowing_and_masking(const Options& options);

/// A lamp with a width, something before it, and where on the ground none, a part, or all of the lamp is seen.
[[nodiscard]] Panel penumbra_geometry(glm::ivec2 size);

/// The directions of a double sum of n1 azimuths and n2 angles: in even steps, and seen from above on the hemisphere,
/// each disc as large as its weight cos θ sin θ.
[[nodiscard]] std::vector<Panel> double_sum_directions(const Options& options, int n1, int n2);

}  // namespace kreda::examples
