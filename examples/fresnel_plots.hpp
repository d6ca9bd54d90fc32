// Fresnel's curves that lesson 40 shows beside its own: over the index of refraction, and of a form without physics.
#pragma once

#include "examples/example.hpp"

namespace kreda::examples {

/// OUT/40_fresnel/index.png: F of four dielectrics from hydrogen to germanium; water, and NVIDIA's form with numbers
/// chosen by hand.
void draw_fresnel_by_index(const Options& options);

}  // namespace kreda::examples
