// How many facets light and viewer see, lighting/microfacet.hpp's G and V, as the papers print them, in long double.
#include <algorithm>
#include <cmath>

#include "tests/stability/exact_facets.hpp"

namespace kreda::tests {

namespace {

using namespace kreda::lighting;

Real root_of(Real c, Real alpha) {
    return std::sqrt(alpha * alpha + (1 - alpha * alpha) * c * c);
}

/// What roughness becomes in them.
std::vector<Formula> parts_of_visibility() {
    return {
        {"alpha_from_roughness",
         "roughness in [0, 1]",
         "[0.002025, 1]",
         0.002025f,
         1,
         true,
         1e-7,
         {kRoughness},
         [](const Inputs& x) { return alpha_from_roughness(x[0]); },
         [](const Inputs& x) { return std::max(Real{x[0]} * x[0], Real(kMinAlpha)); }},
        {"schlick_k_direct",
         "roughness in [0, 1]",
         "[1/8, 1/2]",
         0.125,
         0.5,
         true,
         2e-7,
         {kRoughness},
         [](const Inputs& x) { return schlick_k_direct(x[0]); },
         [](const Inputs& x) { return (Real{x[0]} + 1) * (Real{x[0]} + 1) / 8; }},
        {"schlick_k_image",
         "alpha in [0.002, 1]",
         "[0.001, 1/2]",
         0.001,
         0.5,
         true,
         0,
         {kAlpha},
         [](const Inputs& x) { return schlick_k_image(x[0]); },
         [](const Inputs& x) { return Real{x[0]} / 2; }},
        {"smith_root",
         "c in [0, 1], alpha in [0.002, 1]",
         "[0.002, 1]",
         0.002,
         1.0000002,
         true,
         2e-7,
         {kCosine, kAlpha},
         [](const Inputs& x) { return smith_root(x[0], x[1]); },
         [](const Inputs& x) { return root_of(x[0], x[1]); }},
    };
}

std::vector<Formula> geometries() {
    const Axis k{0.001f, 0.5f, Spread::even, {0.125f}};
    const Axis lamp{0.125f, 0.5f, Spread::even, {}};
    return {
        {"schlick_ggx_g1",
         "c in [0, 1], k in [0.001, 1/2]",
         "[0, 1]",
         0,
         1,
         false,
         4e-7,
         {kCosine, k},
         [](const Inputs& x) { return schlick_ggx_g1(x[0], x[1]); },
         [](const Inputs& x) {
             const Real below = x[0] * (1 - Real{x[1]}) + x[1];
             return below > 0 ? x[0] / below : Real{0};
         }},
        {"schlick_ggx_visibility",
         "n·l, n·v in [0, 1], k in [1/8, 1/2]",
         "[0.249, 16]",
         0.249,
         16,
         true,
         5e-7,
         {kCosine, kCosine, lamp},
         [](const Inputs& x) { return schlick_ggx_visibility(x[0], x[1], x[2]); },
         [](const Inputs& x) {
             const auto below = [&](Real c) { return c * (1 - Real{x[2]}) + x[2]; };
             return 1 / (4 * below(x[0]) * below(x[1]));
         }},
        {"smith_g1",
         "c in [0, 1], alpha in [0.002, 1]",
         "[0, 1]",
         0,
         1,
         false,
         4e-7,
         {kCosine, kAlpha},
         [](const Inputs& x) { return smith_g1(x[0], x[1]); },
         [](const Inputs& x) { return 2 * Real{x[0]} / (x[0] + root_of(x[0], x[1])); }},
        {"smith_visibility",
         "n·l, n·v in [0, 1], alpha in [0.002, 1]",
         "[0.249, 2.5e5]",
         0.249,
         2.5e5,
         true,
         1e-6,
         {kCosine, kCosine, kAlpha},
         [](const Inputs& x) { return smith_visibility(x[0], x[1], x[2]); },
         [](const Inputs& x) { return 1 / ((x[0] + root_of(x[0], x[2])) * (x[1] + root_of(x[1], x[2]))); }},
        {"smith_correlated_visibility",
         "n·l, n·v in [0, 1], one of them > 1e-8, alpha in [0.002, 1]",
         "[0.249, 5e11]",
         0.249,
         5.1e11,
         true,
         1e-6,
         {kCosine, {1e-8f, 1.0f, Spread::even, {1e-4f, 0.5f}}, kAlpha},
         [](const Inputs& x) { return smith_correlated_visibility(x[0], x[1], x[2]); },
         [](const Inputs& x) {
             const Real below = x[0] * root_of(x[1], x[2]) + x[1] * root_of(x[0], x[2]);
             return 1 / (2 * std::max(below, Real(1e-12f)));
         }},
        {"cook_torrance_visibility",
         "n·l, n·v, n·h, v·h in [0, 1]",
         "[0, 5e11]",
         0,
         5.1e11,
         true,
         5e-7,
         {kCosine, kCosine, kCosine, kCosine},
         [](const Inputs& x) { return cook_torrance_visibility(x[0], x[1], x[2], x[3]); },
         [](const Inputs& x) {
             const Real m = std::max<Real>(std::min(x[0], x[1]), 1e-12f),
                        M = std::max<Real>(std::max(x[0], x[1]), 1e-6f);
             return std::min(1 / (2 * m), x[2] / std::max<Real>(x[3], 1e-6f)) / (2 * M);
         }},
    };
}

}  // namespace

std::vector<Formula> formulas_of_visibility() {
    return joined(parts_of_visibility(), geometries());
}

}  // namespace kreda::tests
