// Schlick's approximation of Fresnel's equations, what was made of it, and the table, in long double.
#include <algorithm>
#include <array>
#include <cmath>

#include "lighting/fresnel.hpp"
#include "tests/stability/exact_fresnel.hpp"

namespace kreda::tests {

namespace {

using namespace kreda::lighting;

Real schlick_of_n(Real c, Real n) {
    return ((n - 1) * (n - 1) + 4 * n * std::pow(1 - c, Real{5})) / ((n + 1) * (n + 1));
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

/// Three channels at once, and numbers that are made once a material.
std::vector<Formula> forms_for_pictures() {
    const Axis metal{0.1f, 10.0f, Spread::logarithmic, {1.0f}};
    static const auto eighths = [] {
        std::array<float, 9> squares{};
        for (std::size_t i = 0; i < squares.size(); ++i) squares[i] = static_cast<float>(i * i) / 64.0f;
        return squares;
    }();
    return {
        formula_of({"fresnel_schlick",
                    "c, R_0 in [0, 1]: three channels",
                    "[0, 1.7321]",
                    1.7321,
                    false,
                    4e-7,
                    {kCosine, kF0},
                    [](const Inputs& x) { return fresnel_schlick(x[0], glm::vec3(x[1], 0.04f, 1.0f)); },
                    [](const Inputs& x) { return Wide(f14(x[0], x[1]), f14(x[0], 0.04f), 1); }}),
        {"fresnel_lookup",
         "c in [-1e-7, 1 + 1e-7], nine values c²",
         "[0, 1]",
         0,
         1,
         false,
         3e-7,
         {{0.0f, 1.0f, Spread::even, {1e-8f}, {-1e-7f, 1.0000001f}}},
         [](const Inputs& x) { return fresnel_lookup(x[0], eighths.data(), 9); },
         [](const Inputs& x) {
             const Real at = 8 * std::clamp(Real{x[0]}, Real{0}, Real{1}), i = std::min(std::floor(at), Real{7}),
                        t = at - i;
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

std::vector<Formula> formulas_of_schlick() {
    return joined(joined(schlick_formulas(), corrected_formulas()), forms_for_pictures());
}

}  // namespace kreda::tests
