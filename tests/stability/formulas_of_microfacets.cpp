// The equations of lighting/microfacet.hpp and ward.hpp as the papers print them, in long double.
#include <algorithm>
#include <cmath>

#include "lighting/microfacet.hpp"
#include "lighting/ward.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

namespace {

using namespace kreda::lighting;

const Axis kAlpha{kMinAlpha, 1.0f, Spread::logarithmic, {0.01f, 0.25f}};
const Axis kAngle{0.0f, 1.57079f, Spread::even, {1e-8f, 1e-4f, 0.002f, 0.785f, 1.57f}};

/// cos and sin^2 of an angle as floats: what the formulas are given.
struct Half {
    float c, s2;
};
Half half_of(float theta) {
    const Real c = std::cos(Real{theta}), s = std::sin(Real{theta});
    return {static_cast<float>(c), static_cast<float>(s * s)};
}

Real ggx(Real c, Real s2, Real alpha) {
    const Real q = s2 + c * c * alpha * alpha;
    return alpha * alpha / (kPi * q * q);
}

Real beckmann(Real c, Real s2, Real alpha) {
    return std::exp(-s2 / (c * c * alpha * alpha)) / (kPi * alpha * alpha * c * c * c * c);
}

Real root_of(Real c, Real alpha) {
    return std::sqrt(alpha * alpha + (1 - alpha * alpha) * c * c);
}

/// The Gaussian's integral over the hemisphere in u = theta / m, up to where exp(-u²) is nothing: five points of Gauss
/// and Legendre in each of twelve parts.
Real exact_normalizer(Real m) {
    constexpr Real kNodes[] = {-0.9061798459386640L, -0.5384693101056831L, 0, 0.5384693101056831L, 0.9061798459386640L};
    constexpr Real kWeights[] = {0.2369268850561891L, 0.4786286704993665L, 0.5688888888888889L, 0.4786286704993665L,
                                 0.2369268850561891L};
    constexpr int kParts = 12;
    const Real half = std::min(kPi / 2 / m, Real{7}) / kParts / 2;
    Real sum = 0;
    for (int part = 0; part < kParts; ++part) {
        for (int i = 0; i < 5; ++i) {
            const Real u = half * (2 * part + 1 + kNodes[i]);
            sum += kWeights[i] * std::exp(-u * u) * std::sin(2 * u * m) / 2;
        }
    }
    return 2 * kPi * m * sum * half;
}

std::vector<Formula> distributions() {
    const std::string domain = "theta_h in [0, 90°), alpha in [0.002, 1]";
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
        {"ggx_distribution",
         domain,
         "[0, 8e4]",
         0,
         8e4,
         true,
         1e-6,
         {kAngle, kAlpha},
         [](const Inputs& x) { return ggx_distribution(half_of(x[0]).c, half_of(x[0]).s2, x[1]); },
         [](const Inputs& x) { return ggx(half_of(x[0]).c, half_of(x[0]).s2, x[1]); }},
        {"beckmann_distribution",
         domain,
         "[0, 8e4]",
         0,
         8e4,
         true,
         1e-4,
         {kAngle, kAlpha},
         [](const Inputs& x) { return beckmann_distribution(half_of(x[0]).c, half_of(x[0]).s2, x[1]); },
         [](const Inputs& x) { return beckmann(half_of(x[0]).c, half_of(x[0]).s2, x[1]); },
         1e-30},
        {"blinn_phong_distribution",
         domain,
         "[0, 8e4]",
         0,
         8e4,
         true,
         1e-4,
         {kAngle, kAlpha},
         [](const Inputs& x) { return blinn_phong_distribution(half_of(x[0]).c, half_of(x[0]).s2, x[1]); },
         [](const Inputs& x) {
             const Real n = 2 / (Real{x[1]} * x[1]) - 2, s2 = half_of(x[0]).s2,
                        c2 = Real{half_of(x[0]).c} * half_of(x[0]).c;
             const Real log_c = s2 < Real(0.25) ? std::log1p(-s2) : std::log(c2);
             return (n + 2) / (2 * kPi) * std::exp(n / 2 * log_c);
         },
         1e-30},
        {"squared_angle",
         "theta in [0, 90°)",
         "[0, 2.468]",
         0,
         2.468,
         false,
         1e-6,
         {kAngle},
         [](const Inputs& x) { return squared_angle(half_of(x[0]).c, half_of(x[0]).s2); },
         [](const Inputs& x) { return Real{x[0]} * x[0]; }},
        {"log_one_minus",
         "sin² of theta in [0, 90°)",
         "[-26, 0]",
         -26,
         0,
         true,
         2.5e-7,
         {kAngle},
         [](const Inputs& x) {
             const Half h = half_of(x[0]);
             return log_one_minus(h.s2, h.c * h.c);
         },
         [](const Inputs& x) {
             const Half h = half_of(x[0]);
             return h.s2 < 0.25f ? std::log1p(-Real{h.s2}) : std::log(Real{h.c} * h.c);
         }},
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

/// What the formulas above are made of.
std::vector<Formula> parts_of_facets() {
    const auto exponent = [](const Inputs& x) {
        const Half h = half_of(x[0]);
        return -h.s2 / (Real{h.c} * h.c * x[1] * x[1]);
    };
    return {
        {"beckmann_exponent",
         "theta_h in [0, 90°), alpha in [0.002, 1]",
         "[-2.5e17, 0]",
         -2.5e17,
         0,
         true,
         5e-7,
         {kAngle, kAlpha},
         [](const Inputs& x) { return beckmann_exponent(half_of(x[0]).c, half_of(x[0]).s2, x[1]); },
         exponent},
        {"gaussian_normalizer",
         "m in [0.002, 1]",
         "[1.2e-5, 1.8]",
         1.2e-5,
         1.8,
         true,
         4e-6,
         {kAlpha},
         [](const Inputs& x) { return gaussian_normalizer(x[0]); },
         [](const Inputs& x) { return exact_normalizer(x[0]); }},
        {"gaussian_distribution",
         "theta_h in [0, 90°), alpha in [0.002, 1]",
         "[0, 8e4]",
         0,
         8e4,
         true,
         1e-4,
         {kAngle, kAlpha},
         [](const Inputs& x) { return gaussian_distribution(half_of(x[0]).c, half_of(x[0]).s2, x[1]); },
         [](const Inputs& x) {
             const Real angle = std::atan2(std::sqrt(Real{half_of(x[0]).s2}), Real{half_of(x[0]).c});
             return std::exp(-angle * angle / (Real{x[1]} * x[1])) / exact_normalizer(x[1]);
         },
         1e-30},
        {"ward_bounded",
         "theta_h in [0, 90°), v·h in [0, 1], alpha in [0.002, 1]",
         "[0, 2e16]",
         0,
         2e16,
         true,
         1e-4,
         {kAngle, kCosine, kAlpha},
         [](const Inputs& x) {
             const Half h = half_of(x[0]);
             return ward_bounded({0.5f, 0.5f, h.c, x[1], h.s2}, x[2]);
         },
         [](const Inputs& x) {
             const Half h = half_of(x[0]);
             return beckmann(h.c, h.s2, x[2]) / (4 * std::max(Real{x[1]} * x[1], Real(1e-12f)));
         },
         1e-20},
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

std::vector<Formula> ward_formulas() {
    const Axis alpha{0.002f, 1.0f, Spread::logarithmic, {0.01f, 0.25f}};
    const Axis exponent{0.0f, 1e9f, Spread::even, {1.0f, 2.0f, 1e3f, 1e6f}};
    const auto angles = [](const Inputs& x) {
        const Half h = half_of(x[2]);
        return MicrofacetAngles{x[0], x[1], h.c, 0.5f, h.s2};
    };
    return {
        {"ward_isotropic",
         "n·l, n·v in [0, 1], theta_h in [0, 90°), alpha in [0.002, 1]",
         "[0, 2e10]",
         0,
         2e10,
         true,
         1e-4,
         {kCosine, kCosine, kAngle, alpha},
         [=](const Inputs& x) { return ward_isotropic(angles(x), x[3]); },
         [](const Inputs& x) {
             const Half h = half_of(x[2]);
             const Real product = x[0] * x[1], c2 = Real{h.c} * h.c, alpha2 = Real{x[3]} * x[3];
             const Real root = std::sqrt(std::max(product, Real(1e-12f)));
             return product > 0 ? std::exp(-h.s2 / (c2 * alpha2)) / (4 * kPi * alpha2 * root) : Real{0};
         },
         1e-30},
        {"ward_alpha_from_shininess",
         "shininess in [0, 1e9]",
         "[0.002, 1]",
         0.002f,
         1,
         true,
         2e-7,
         {exponent},
         [](const Inputs& x) { return ward_alpha_from_shininess(x[0]); },
         [](const Inputs& x) { return std::max(std::sqrt(2 / (Real{x[0]} + 2)), Real(0.002f)); }},
        {"sine_from_cosine",
         "x in [-1, 1]",
         "[0, 1]",
         0,
         1,
         false,
         2e-7,
         {{-1.0f, 1.0f, Spread::even, {0.0f, 1e-8f, -1e-8f}}},
         [](const Inputs& x) { return sine_from_cosine(x[0]); },
         [](const Inputs& x) { return std::sqrt((1 - Real{x[0]}) * (1 + Real{x[0]})); }},
    };
}

}  // namespace

std::vector<Formula> formulas_of_microfacets() {
    std::vector<Formula> all = distributions();
    for (const std::vector<Formula>& more : {geometries(), parts_of_facets(), ward_formulas()}) {
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

}  // namespace kreda::tests
