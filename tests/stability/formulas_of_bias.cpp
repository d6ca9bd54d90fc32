// The bias formulas of shadows/map_point.hpp in long double.
#include <algorithm>
#include <cmath>

#include "shadows/soft_filter.hpp"
#include "tests/stability/exact_bias.hpp"

namespace kreda::tests {

namespace {

using namespace kreda::shadows;

/// How a surface leans on the map.
std::vector<Formula> formulas_of_slopes() {
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

/// The soft edge, the bias and the place on the map.
std::vector<Formula> formulas_of_maps() {
    const Axis cosine{-1.0f, 1.0f, Spread::even, {-1e-8f, 0.0f, 1e-8f, 0.01f}};
    const Axis place{-1.0f, 1.0f, Spread::even, {0.0f, 1e-8f}};
    const Axis distance{1e-3f, 1e6f, Spread::logarithmic, {1.0f}};
    const Axis big{1e-15f, 1e18f, Spread::logarithmic, {1.0f}};
    const auto slope_u = [](Real n_u, Real n_z, Real at_u, Real far_away) {
        const Real of_ray = -(n_u * at_u - n_z * far_away) / far_away;
        return n_u * far_away / limited(of_ray) * kPicture.texel.x;
    };
    return {
        {"half_cone",
         "half width in [0, 1e6], receiver >= blocker in [0.001, 1e6]",
         "[0, 1e9]",
         0,
         1e9,
         true,
         4e-7,
         {{0.0f, 1e6f, Spread::even, {1.0f}}, distance, {1.0f, 1e3f, Spread::logarithmic, {2.0f}}},
         [](const Inputs& x) { return half_cone(x[0], x[1] * x[2], x[1], true); },
         [](const Inputs& x) {
             const Real receiver = x[1] * x[2];
             return x[0] * (receiver - x[1]) / (receiver * x[1]);
         }},
        {"least_bias",
         "slopes in [1e-15, 1e18]",
         "[0, 1e18]",
         0,
         1.0000001e18,
         true,
         1.3e-7,
         {big, big},
         [](const Inputs& x) {
             return least_bias({x[0], -x[1]});
         },
         [](const Inputs& x) { return (Real{x[0]} + x[1]) / 2; }},
        {"offset_factor",
         "cosine in [-1, 1], a normal offset of 2 and a slope of 1",
         "[-3, 2]",
         -3,
         2,
         false,
         0,
         {cosine},
         [](const Inputs& x) {
             return offset_factor({0.0f, 1.0f, 2.0f, 0.0f}, x[0]);
         },
         [](const Inputs& x) { return x[0] < 0.0f ? Real{-3} : Real{2}; }},
        {"slope_factor",
         "cosine in [-1, 1], a slope of 1",
         "[0, 1]",
         0,
         1,
         false,
         0,
         {cosine},
         [](const Inputs& x) { return slope_factor(kSlopeBias, x[0]); },
         [](const Inputs& x) { return x[0] < 0.0f ? Real{0} : Real{1}; }},
        {"slope_perspective",
         "n unit, the point in a picture of 90°, distance in [0.001, 1e6]: u in distances",
         "[-0.2, 0.2]",
         -0.21,
         0.21,
         false,
         3e-5,
         {kHeight, {0.1f, 1.0f, Spread::even, {}}, distance},
         [](const Inputs& x) {
             const glm::vec3 n = direction(x[0], 0.0f), q{x[1] * x[2], 0.0f, -x[2]};
             return slope_perspective(n, q, x[2], kPicture.texel).u / x[2];
         },
         [=](const Inputs& x) {
             const glm::vec3 n = direction(x[0], 0.0f);
             return slope_u(n.x, n.z, Real{x[1] * x[2]}, x[2]) / x[2];
         }},
        {"map_point_perspective",
         "the point in a picture of 90° and 1024 texels, distance in [0.001, 1e6]: u",
         "[0, 1024]",
         0,
         1024,
         false,
         1.3e-4,
         {place, distance},
         [](const Inputs& x) {
             return map_point_perspective({x[0] * x[1], 0.0f, -x[1]}, {0.0f, 0.0f, 1.0f}, kPicture, kSlopeBias).u;
         },
         [](const Inputs& x) { return Real{x[0] * x[1]} / x[1] * 512 + 512; }},
        {"map_steps_parallel",
         "the point in a picture 2 wide with 1024 texels: u",
         "[0, 1024]",
         0,
         1024,
         false,
         1.3e-4,
         {place},
         [](const Inputs& x) {
             return map_steps_parallel({x[0], 0.0f, 0.5f}, {0.0f, 0.0f, 1.0f}, kPicture, kSlopeBias).point.u;
         },
         [](const Inputs& x) { return x[0] * Real{512} + 512; }},
        {"map_point_parallel",
         "n·l in [-1, 1], distance in [0.001, 1e6]: the biased distance",
         "[0, 1e6]",
         -0.2,
         1e6,
         false,
         0.07,
         {kHeight, distance},
         [](const Inputs& x) {
             const glm::vec3 n = direction(x[0], 0.0f);
             return map_point_parallel({0.0f, 0.0f, -x[1]}, n, kPicture, kSlopeBias).distance;
         },
         [](const Inputs& x) {
             const glm::vec3 n = direction(x[0], 0.0f);
             const Real slope = std::fabs(n.x / limited(n.z) * kPicture.texel.x);
             return x[1] - Real{1e-3f} - (n.z < 0.0f ? 0 : slope / 2);
         }},
    };
}

}  // namespace

std::vector<Formula> formulas_of_bias() {
    return joined(formulas_of_slopes(), formulas_of_maps());
}

}  // namespace kreda::tests
