// The equations of lighting/fresnel.hpp as the papers print them, in long double.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <utility>

#include "lighting/fresnel.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

namespace {

using namespace kreda::lighting;

const Axis kRatio{0.001f, 1000.0f, Spread::logarithmic, {0.1f, 0.2f, 1.0f, 1.5f}};
const Axis kF0{0.0f, 1.0f, Spread::even, {1e-8f, 0.04f, 0.5f}};
/// What is smaller than 1e-12 stands for 0.
const Axis kExtinction{0.0f, 1000.0f, Spread::even, {1e-8f, 1e-4f, 1.0f, 10.0f, 100.0f}};

float extinction(float k) {
    return k < 1e-12f ? 0.0f : k;
}

/// Fresnel's equations with a complex index: the textbook form, with tan and arcsine nowhere.
Real exact_fresnel(Real c, Real n, Real k) {
    using Complex = std::complex<Real>;
    const Complex m(n, k);
    const Complex root = std::sqrt((m - Real{1}) * (m + Real{1}) + Complex(c * c));  // m cos theta_t
    const Complex below_s = c + root, below_p = m * m * c + root;
    if (std::abs(below_s) == 0 || std::abs(below_p) == 0) return 0;  // n = 1 at 90 degrees
    return (std::norm((c - root) / below_s) + std::norm((m * m * c - root) / below_p)) / 2;
}

Real f14(Real c, Real f0) {
    return f0 + (1 - f0) * std::pow(1 - c, Real{5});
}

Real schlick_of_n(Real c, Real n) {
    return ((n - 1) * (n - 1) + 4 * n * std::pow(1 - c, Real{5})) / ((n + 1) * (n + 1));
}

Real exact_refracted(Real c, Real n) {
    const Real cos2 = ((n - 1) * (n + 1) + c * c) / (n * n);
    return std::sqrt(std::max(cos2, Real{0}));
}

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
         4e-4,
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

std::vector<Formula> schlick_formulas() {
    return {
        {"schlick_weight",
         "c in [0, 1]",
         "[0, 1]",
         0,
         1,
         false,
         3e-7,
         {kCosine},
         [](const Inputs& x) { return schlick_weight(x[0]); },
         [](const Inputs& x) { return std::pow(Real{1} - x[0], Real{5}); }},
        {"fresnel_schlick",
         "c, R_0 in [0, 1]",
         "[0, 1]",
         0,
         1,
         false,
         4e-7,
         {kCosine, kF0},
         [](const Inputs& x) { return fresnel_schlick(x[0], x[1]); },
         [](const Inputs& x) { return f14(x[0], x[1]); }},
        {"fresnel_schlick_from_index",
         "c in [0, 1], n in [0.001, 1000]",
         "[0, 1]",
         0,
         1,
         false,
         6e-7,
         {kCosine, kRatio},
         [](const Inputs& x) { return fresnel_schlick_from_index(x[0], x[1]); },
         [](const Inputs& x) { return schlick_of_n(x[0], x[1]); }},
        {"fresnel_schlick_between",
         "c in [0, 1], n in [0.001, 1000]",
         "[0, 1]",
         0,
         1,
         false,
         2e-3,
         {kCosine, kRatio},
         [](const Inputs& x) { return fresnel_schlick_between(x[0], x[1]); },
         [](const Inputs& x) { return schlick_of_n(x[1] < 1 ? exact_refracted(x[0], x[1]) : Real{x[0]}, x[1]); }},
        {"fresnel_rescaled_schlick",
         "c in [0, 1], n in [0.001, 1000], k in [0, 1000]",
         "[0, 1]",
         0,
         1,
         false,
         6e-7,
         {kCosine, kRatio, kExtinction},
         [](const Inputs& x) { return fresnel_rescaled_schlick(x[0], x[1], x[2]); },
         [](const Inputs& x) { return f14(x[0], exact_fresnel(1, x[1], x[2])); }},
    };
}

std::vector<Formula> corrected_formulas() {
    const Axis a{0.0f, 20.0f, Spread::even, {}}, lambda{0.0f, 100.0f, Spread::even, {1.0f}};
    const Axis b{-20.0f, 20.0f, Spread::even, {0.0f}};
    const auto corrected = [](Real c, Real f0, Real a_, Real lambda_) {
        return f14(c, f0) - a_ * c * std::pow(1 - c, lambda_);
    };
    return {
        {"fresnel_corrected_schlick",
         "c, R_0 in [0, 1], a in [0, 20], lambda in [0, 100]",
         "[0, 1]",
         0,
         1,
         false,
         4e-6,
         {kCosine, kF0, a, lambda},
         [](const Inputs& x) { return fresnel_corrected_schlick(x[0], x[1], x[2], x[3]); },
         [=](const Inputs& x) { return std::max(corrected(x[0], x[1], x[2], x[3]), Real{0}); }},
        {"fresnel_corrected_schlick_as_printed",
         "c, R_0 in [0, 1], a in [0, 20], lambda in [0, 100]",
         "[-20, 1]",
         -20,
         1,
         false,
         5e-5,
         {kCosine, kF0, a, lambda},
         [](const Inputs& x) { return fresnel_corrected_schlick_as_printed(x[0], x[1], x[2], x[3]); },
         [](const Inputs& x) { return f14(x[0], x[1]) - Real{x[2]} * std::pow(Real{1} - x[0], Real{x[3]}); }},
        {"fresnel_f82",
         "c, R_0 in [0, 1], b in [-20, 20]",
         "[0, 1]",
         0,
         1,
         false,
         2e-6,
         {kCosine, kF0, b},
         [](const Inputs& x) { return fresnel_f82(x[0], x[1], x[2]); },
         [](const Inputs& x) {
             const Real F = f14(x[0], x[1]) - Real{x[2]} * x[0] * std::pow(Real{1} - x[0], Real{6});
             return std::clamp(F, Real{0}, Real{1});
         }},
        {"f82_coefficient",
         "R_0, F(1/7) in [0, 1]",
         "[-18, 18]",
         -18,
         18,
         false,
         5e-6,
         {kF0, kF0},
         [](const Inputs& x) { return f82_coefficient(x[0], x[1]); },
         [](const Inputs& x) { return (f14(Real{1} / 7, x[0]) - x[1]) * 7 * std::pow(Real{7} / 6, Real{6}); }},
        {"fresnel_nvidia",
         "c, bias, scale in [0, 1], power in [0, 1000]",
         "[0, 1]",
         0,
         1,
         false,
         2e-5,
         {kCosine, kF0, kF0, {0.0f, 1000.0f, Spread::even, {1.0f, 5.0f}}},
         [](const Inputs& x) { return fresnel_nvidia(x[0], x[1], x[2], x[3]); },
         [](const Inputs& x) { return std::min(x[1] + Real{x[2]} * std::pow(Real{1} - x[0], Real{x[3]}), Real{1}); }},
    };
}

/// What F is made of, and what makes it cheaper.
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
    static const auto eighths = [] {
        std::array<float, 9> squares{};
        for (std::size_t i = 0; i < squares.size(); ++i) squares[i] = static_cast<float>(i * i) / 64.0f;
        return squares;
    }();
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
        formula_of({"fresnel_schlick",
                    "c, R_0 in [0, 1]: three channels",
                    "[0, 1.7321]",
                    1.7321,
                    false,
                    4e-7,
                    {kCosine, kF0},
                    [](const Inputs& x) { return fresnel_schlick(x[0], glm::vec3(x[1], 0.04f, 1.0f)); },
                    [](const Inputs& x) { return Wide(f14(x[0], x[1]), f14(x[0], 0.04f), 1); }}),
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
        {"fresnel_lookup",
         "c in [0, 1], nine values c²",
         "[0, 1]",
         0,
         1,
         false,
         3e-7,
         {kCosine},
         [](const Inputs& x) { return fresnel_lookup(x[0], eighths.data(), 9); },
         [](const Inputs& x) {
             const Real at = 8 * Real{x[0]}, i = std::min(std::floor(at), Real{7}), t = at - i;
             return ((1 - t) * i * i + t * (i + 1) * (i + 1)) / 64;
         }},
        {"f82_coefficient_from_index",
         "n, k in [0.1, 10]",
         "[-18, 18]",
         -18,
         18,
         false,
         1e-5,
         {metal, metal},
         [](const Inputs& x) { return f82_coefficient_from_index(glm::vec3(x[0]), glm::vec3(x[1])).x; },
         [](const Inputs& x) {
             const Real c = Real{1} / 7, F = exact_fresnel(c, x[0], x[1]);
             return (f14(c, exact_fresnel(1, x[0], x[1])) - F) * 7 * std::pow(Real{7} / 6, Real{6});
         }},
    };
}

}  // namespace

std::vector<Formula> formulas_of_fresnel() {
    std::vector<Formula> all = exact_formulas();
    for (const std::vector<Formula>& more : {schlick_formulas(), corrected_formulas(), parts_of_fresnel()}) {
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

}  // namespace kreda::tests
