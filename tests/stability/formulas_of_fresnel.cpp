// The equations of lighting/fresnel.hpp that are exact, beside the papers' in long double.
#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "lighting/fresnel.hpp"
#include "tests/stability/exact_fresnel.hpp"

namespace kreda::tests {

namespace {

using namespace kreda::lighting;

/// The lower n, the steeper F is at the critical angle, where the largest error is.
Formula dielectric(const std::string& domain, float low, float high, double most_error) {
    return {"fresnel_dielectric",
            domain,
            "[0, 1]",
            0,
            1,
            false,
            most_error,
            {kCosine, {low, high, Spread::logarithmic, {0.2f, 0.7f, 1.5f}}},
            [](const Inputs& x) { return fresnel_dielectric(x[0], x[1]); },
            [](const Inputs& x) { return exact_fresnel(x[0], x[1], 0); }};
}

std::vector<Formula> exact_formulas() {
    return {
        {"refracted_cosine",
         "c in [0, 1], n in [0.001, 1000]",
         "[0, 1]",
         0,
         1,
         false,
         2e-6,
         {kCosine, kRatio},
         [](const Inputs& x) { return refracted_cosine(x[0], x[1]); },
         [](const Inputs& x) { return exact_refracted(x[0], x[1]); }},
        dielectric("c in [0, 1], n in [1, 1000]", 1.0f, 1000.0f, 7e-7),
        dielectric("c in [0, 1], n in [0.1, 1]", 0.1f, 1.0f, 6e-3),
        dielectric("c in [0, 1], n in [0.001, 0.1]", 0.001f, 0.1f, 7e-2),
        {"fresnel_conductor",
         "c in [0, 1], n in [0.001, 1000], k = 0 or in [1e-12, 1000]",
         "[0, 1]",
         0,
         1,
         false,
         4e-4,
         {kCosine, kRatio, kExtinction},
         [](const Inputs& x) { return fresnel_conductor(x[0], x[1], extinction(x[2])); },
         [](const Inputs& x) { return exact_fresnel(x[0], x[1], extinction(x[2])); }},
        {"f0_from_index",
         "n in [0.001, 1000], k in [0, 1000]",
         "[0, 1]",
         0,
         1,
         false,
         4e-7,
         {kRatio, kExtinction},
         [](const Inputs& x) { return f0_from_index(x[0], x[1]); },
         [](const Inputs& x) { return exact_fresnel(1, x[0], x[1]); }},
        {"index_from_f0",
         "R_0 in [0, 1]",
         "[1, 39999]",
         1,
         39999,
         true,
         2e-3,
         {kF0},
         [](const Inputs& x) { return index_from_f0(x[0]); },
         [](const Inputs& x) {
             const Real root = std::sqrt(std::min<Real>(x[0], Real(0.9999f)));
             return (1 + root) / (1 - root);
         }},
    };
}

/// What F is made of.
std::vector<Formula> parts_of_fresnel() {
    const Axis dense{1.0f, 1000.0f, Spread::logarithmic, {1.5f}};
    const Axis metal{0.1f, 10.0f, Spread::logarithmic, {1.0f}};
    using Complex = std::complex<Real>;
    const auto share_s = [](Real c, Complex m) {
        const Complex root = std::sqrt((m - Real{1}) * (m + Real{1}) + Complex(c * c));
        return std::abs(c + root) == 0 ? Real{0} : std::norm((c - root) / (c + root));
    };
    const auto exact_polarized = [=](Real c, Real n, Real k) {
        const Real both = exact_fresnel(c, n, k), s = share_s(c, Complex(n, k));
        return std::pair(s, 2 * both - s);
    };
    return {
        {"fresnel_dielectric_polarized",
         "c in [0, 1], n in [1, 1000]: s",
         "[0, 1.0000004]",
         0,
         1.0000004,
         false,
         1e-6,
         {kCosine, dense},
         [](const Inputs& x) { return fresnel_dielectric_polarized(x[0], x[1]).s; },
         [=](const Inputs& x) { return exact_polarized(x[0], x[1], 0).first; }},
        {"fresnel_dielectric_polarized",
         "c in [0, 1], n in [1, 1000]: p",
         "[0, 1.0000004]",
         0,
         1.0000004,
         false,
         1e-6,
         {kCosine, dense},
         [](const Inputs& x) { return fresnel_dielectric_polarized(x[0], x[1]).p; },
         [=](const Inputs& x) { return exact_polarized(x[0], x[1], 0).second; }},
        {"fresnel_conductor_polarized",
         "c in [0, 1], n, k in [0.1, 10]: p",
         "[0, 1.0000004]",
         0,
         1.0000004,
         false,
         1e-6,
         {kCosine, metal, metal},
         [](const Inputs& x) { return fresnel_conductor_polarized(x[0], x[1], x[2]).p; },
         [=](const Inputs& x) { return exact_polarized(x[0], x[1], x[2]).second; }},
        {"unpolarized",
         "s, p in [0, 1]",
         "[0, 1]",
         0,
         1,
         false,
         1e-7,
         {kF0, kF0},
         [](const Inputs& x) {
             return unpolarized({x[0], x[1]});
         },
         [](const Inputs& x) { return (Real{x[0]} + x[1]) / 2; }},
        {"relative_index",
         "both in [0.03, 30]",
         "[0.001, 1000]",
         0.00099,
         1001,
         true,
         1e-7,
         {{0.03f, 30.0f, Spread::logarithmic, {1.0f}}, {0.03f, 30.0f, Spread::logarithmic, {1.0f}}},
         [](const Inputs& x) { return relative_index(x[0], x[1]); },
         [](const Inputs& x) { return Real{x[1]} / x[0]; }},
    };
}

}  // namespace

std::vector<Formula> formulas_of_fresnel() {
    return joined(exact_formulas(), parts_of_fresnel());
}

}  // namespace kreda::tests
