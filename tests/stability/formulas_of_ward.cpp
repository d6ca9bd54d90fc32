// Ward's models, lighting/ward.hpp, as the papers print them, in long double.
#include <algorithm>
#include <cmath>

#include "lighting/ward.hpp"
#include "tests/stability/exact_facets.hpp"
#include "tests/stability/two_directions.hpp"

namespace kreda::tests {

namespace {

using namespace kreda::lighting;

std::vector<Formula> isotropic_ward() {
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
             return exact_beckmann(h.c, h.s2, x[2]) / (4 * std::max(Real{x[1]} * x[1], Real(1e-12f)));
         },
         1e-20},
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
         "x in [-1 - 1e-7, 1 + 1e-7]",
         "[0, 1]",
         0,
         1,
         false,
         2e-7,
         {{-1.0f, 1.0f, Spread::even, {0.0f, 1e-8f, -1e-8f}, {-1.0000001f, 1.0000001f}}},
         [](const Inputs& x) { return sine_from_cosine(x[0]); },
         [](const Inputs& x) { return std::sqrt(std::max((1 - Real{x[0]}) * (1 + Real{x[0]}), Real{0})); }},
    };
}

/// tan² theta_h times the share of each width, in long double.
Real grain_exponent(const Wide& h, Real alpha_t, Real alpha_b) {
    const Real slopes = h.x * h.x / (alpha_t * alpha_t) + h.y * h.y / (alpha_b * alpha_b);
    return slopes / std::max(h.z * h.z, Real(1e-12f));
}

std::vector<Formula> ward_family() {
    const Axis alpha{0.002f, 1.0f, Spread::logarithmic, {}};
    const auto h_of = [](const Inputs& x) { return wide_unit(Wide(l_of(x)) + Wide(v_of(x))); };
    const std::vector<Axis> above = {kUpperHeight, kAnyTurn, kUpperHeight, kAnyTurn, alpha, alpha};
    const auto exact_ward = [=](const Inputs& x) {
        const Real product = positive(x[0]) * positive(x[2]);
        if (product <= 0) return Real{0};
        const Real lobe = std::exp(-grain_exponent(h_of(x), x[4], x[5])) / (4 * kPi * x[4] * x[5]);
        return lobe / std::sqrt(std::max(product, Real(1e-12f)));
    };
    const glm::vec3 t{1.0f, 0.0f, 0.0f}, b{0.0f, 1.0f, 0.0f};
    return {
        {"ward_exponent",
         "h, n, t, b unit to 3e-7, both alpha in [0.002, 1]",
         "[0, 2.6e17]",
         0,
         2.6e17,
         true,
         6e-7,
         {kHeight, kTurn, alpha, alpha},
         [=](const Inputs& x) { return ward_exponent(direction(x[0], x[1]), kUp, t, b, x[2], x[3]); },
         [](const Inputs& x) { return grain_exponent(Wide(direction(x[0], x[1])), x[2], x[3]); }},
        {"ward_anisotropic", "all unit to 3e-7, n·l, n·v in [0, 1], both alpha in [0.002, 1]", "[0, 2e10]", 0, 2e10,
         true, 3e-3, above, [=](const Inputs& x) { return ward_anisotropic(kUp, t, b, l_of(x), v_of(x), x[4], x[5]); },
         exact_ward, 1e-25},
        {"ward_brushed", "as ward_anisotropic: specular, m_S = 0.5", "[0, 4e10]", 0, 4e10, true, 3e-3, above,
         [=](const Inputs& x) {
             return ward_brushed(kUp, t, l_of(x), v_of(x), shiny(1.0f), {x[4], x[5]}).specular.x;
         },
         [=](const Inputs& x) { return Real{0.5f} * kPi * exact_ward(x) * positive(x[0]); }, 1e-25},
        {"ward",
         "n, l, v unit to 3e-7, n·l, n·v in [0, 1], shininess in [0, 1000]: specular, m_S = 0.5",
         "[0, 4e8]",
         0,
         4e8,
         true,
         3e-3,
         {kUpperHeight, kAnyTurn, kUpperHeight, kAnyTurn, {1e-3f, 1e3f, Spread::logarithmic, {1.0f, 64.0f}, {0.0f}}},
         [](const Inputs& x) { return ward(kUp, l_of(x), v_of(x), shiny(x[4])).specular.x; },
         [=](const Inputs& x) {
             const Real width = std::sqrt(2 / (Real{x[4]} + 2));
             const Real product = positive(x[0]) * positive(x[2]);
             if (product <= 0) return Real{0};
             const Real lobe = std::exp(-grain_exponent(h_of(x), width, width)) / (4 * width * width);
             return Real{0.5f} * lobe / std::sqrt(std::max(product, Real(1e-12f))) * x[0];
         },
         1e-25},
    };
}

}  // namespace

std::vector<Formula> formulas_of_ward() {
    return joined(isotropic_ward(), ward_family());
}

}  // namespace kreda::tests
