// Scale and bias of the split sum by quadrature in double: what the map and the fit are held to.
#pragma once

#include "lighting/environment/brdf_map.hpp"

namespace kreda::tools {

/// A and B of GGX with Smith's height-correlated G: steps x steps facets that v sees, in the middle of even cells,
/// denser at both ends. 4e-5 with 128 steps.   n_dot_v in (0, 1].
[[nodiscard]] lighting::BrdfTerms brdf_by_quadrature(double n_dot_v, double roughness, int steps);

}  // namespace kreda::tools
