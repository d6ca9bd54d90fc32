// The bias formulas of shadows/map_point.hpp in long double.
#include <algorithm>
#include <cmath>

#include "shadows/map_point.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

namespace {

using namespace kreda::shadows;

Real limited(Real cosine) {
    const Real size = std::max(std::fabs(cosine), Real(kLeastCosine));
    return cosine < 0 ? -size : size;
}

}  // namespace

std::vector<Formula> formulas_of_shadows() {
    const Axis cosine{-1.0f, 1.0f, Spread::even, {-1e-8f, 0.0f, 1e-8f, 0.01f}};
    const Axis texel{1e-18f, 1e18f, Spread::logarithmic, {1.0f}};
    return {
        {"steepness_limit",
         "cosine in [-1, 1]",
         "[-1, 1] without (-0.01, 0.01)",
         -1,
         1,
         false,
         0,
         {cosine},
         [](const Inputs& x) { return steepness_limit(x[0]); },
         [](const Inputs& x) { return limited(x[0]); }},
        {"slope_parallel",
         "length of n up to 1, texel in [1e-18, 1e18]: its u",
         "[-1e20, 1e20]",
         -1.0001e20,
         1.0001e20,
         true,
         3e-7,
         {cosine, cosine, texel},
         [](const Inputs& x) {
             return slope_parallel({x[0], 0.0f, x[1]}, glm::vec2(x[2])).u;
         },
         [](const Inputs& x) { return x[0] / limited(x[1]) * x[2]; }},
        {"least_normal_offset",
         "length of n up to 1, texel in [1e-18, 1e18]",
         "[0, 1e18]",
         0,
         1.0001e18,
         true,
         3e-7,
         {cosine, cosine, texel},
         [](const Inputs& x) {
             return least_normal_offset({x[0], x[1], 0.0f}, glm::vec2(x[2]));
         },
         [](const Inputs& x) { return (std::fabs(Real{x[0]}) + std::fabs(Real{x[1]})) * x[2] / 2; }},
    };
}

}  // namespace kreda::tests
