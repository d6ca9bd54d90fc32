// The built-in skies, and what a surface sees of an environment (lighting/environment/): beside the same in long
// double.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "lighting/environment/brdf_map.hpp"
#include "lighting/environment/irradiance.hpp"
#include "lighting/environment/prefilter.hpp"
#include "lighting/environment/sky.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

namespace {

using glm::vec3;

/// A direction of the environment: y is up.
vec3 direction_of_sky(const Inputs& x) {
    const vec3 d = direction(x[0], x[1]);
    return {d.x, d.z, d.y};
}

/// 0 before `from`, 1 behind `to`.
Real exact_step(Real from, Real to, Real x) {
    const Real t = std::clamp((x - from) / (to - from), Real{0}, Real{1});
    return t * t * (3 - 2 * t);
}

Wide blend(const Wide& a, const Wide& b, Real t) {
    return a * (1 - t) + b * t;
}

Wide exact_gradient(const Wide& d) {
    const Real toward = std::max(Real{0}, glm::dot(d, glm::normalize(Wide(0.4L, 0.8L, 0.3L))));
    return blend({0.3L, 0.25L, 0.2L}, {0.4L, 0.6L, 1}, (d.y + 1) / 2) + Wide(20 * std::pow(toward, 256));
}

/// The sides of a box of light: whither its middle lies, and along what its half widths are.
struct Box {
    Wide center, right, up;
};

/// `half_width` x `half_height` on the plane that touches the sphere in the box's middle.
Real exact_box(const Wide& d, const Box& box, Real half_width, Real half_height) {
    const Real along = glm::dot(d, box.center), divisor = std::max(along, Real(0.05L));
    const auto inside = [&](const Wide& axis, Real half) {
        return 1 - exact_step(half - 0.04L, half + 0.04L, std::fabs(glm::dot(d, axis)) / divisor);
    };
    return exact_step(0.05L, 0.15L, along) * inside(box.right, half_width) * inside(box.up, half_height);
}

/// The three boxes stand where the sky's definition has them, to its eight digits: it says how the room is lit.
Wide exact_studio(const Wide& d) {
    const Box key{{-0.57207754L, 0.57207754L, 0.58777855L},
                  {0.71658188L, 0, 0.69750300L},
                  {0.39902518L, 0.82021287L, -0.40993973L}};
    const Box fill{{0.93632918L, 0.28089875L, 0.21067407L},
                   {0.21951221L, 0, -0.97560976L},
                   {-0.27404749L, 0.95973597L, -0.06166068L}};
    const Box strip{{0, 0.31622777L, -0.94868330L}, {1, 0, 0}, {0, 0.94868330L, 0.31622777L}};
    return Wide(0.06L, 0.065L, 0.075L) + Wide(0.16L, 0.15L, 0.14L) * exact_step(0.1L, -0.6L, d.y) +
           Wide(9, 8.6L, 8) * exact_box(d, key, 0.5L, 0.35L) + Wide(1.6L, 1.9L, 2.4L) * exact_box(d, fill, 0.3L, 0.6L) +
           Wide(5, 5, 5.2L) * exact_box(d, strip, 0.9L, 0.12L);
}

Wide exact_sunset(const Wide& d) {
    const Real near_horizon = std::exp(-5 * std::max(d.y, Real{0}));
    const Real toward = std::max(Real{0}, glm::dot(d, Wide(0.2L, 0.09950372L, -0.97472L)));
    const Real sun = exact_step(std::cos(kPi / 60), std::cos(kPi / 90), toward);
    const Wide above = blend({0.10L, 0.16L, 0.36L}, {0.75L, 0.36L, 0.20L}, near_horizon) +
                       Wide(1.6L, 0.62L, 0.16L) * std::pow(toward, 8) * near_horizon + Wide(260, 110, 32) * sun;
    const Wide ground = Wide(0.055L, 0.045L, 0.04L) + Wide(0.12L, 0.05L, 0.02L) * std::pow(toward, 4);
    return blend(ground, above, exact_step(-0.01L, 0.01L, d.y));
}

VectorFormula sky_formula(const std::string& name, double longest, double most_error, vec3 (*value)(const vec3&),
                          Wide (*exact)(const Wide&)) {
    return {name,
            "d unit",
            "[0, " + std::to_string(static_cast<int>(longest)) + "]",
            longest,
            false,
            most_error,
            {kHeight, kTurn},
            [=](const Inputs& x) { return value(direction_of_sky(x)); },
            [=](const Inputs& x) { return exact(Wide(direction_of_sky(x))); }};
}

std::vector<Formula> formulas_of_built_in_skies() {
    const Axis edge{-1.0f, 0.0f, Spread::even, {}}, other{0.08f, 1.0f, Spread::even, {}};
    const Axis half{0.05f, 50.0f, Spread::logarithmic, {}};
    return {
        {"smooth_step",
         "from in [-1, 0], to in [0.08, 1], x in [-2, 2]",
         "[0, 1]",
         0,
         1.0000002,
         false,
         1e-6,
         {edge, other, {-2.0f, 2.0f, Spread::even, {0.0f, 0.5f}}},
         [](const Inputs& x) { return lighting::smooth_step(x[0], x[1], x[2]); },
         [](const Inputs& x) { return exact_step(x[0], x[1], x[2]); }},
        {"soft_box",
         "d unit, half widths in [0.05, 50]",
         "[0, 1]",
         0,
         1.0000002,
         false,
         1e-5,
         {kHeight, kTurn, half, half},
         [](const Inputs& x) {
             return lighting::soft_box(direction_of_sky(x), {0.0f, 0.0f, 1.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f},
                                       x[2], x[3]);
         },
         [](const Inputs& x) {
             return exact_box(Wide(direction_of_sky(x)), {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, x[2], x[3]);
         }},
        formula_of(sky_formula("gradient_sky", 36, 2e-3, lighting::gradient_sky, exact_gradient)),
        formula_of(sky_formula("studio_sky", 16, 1e-4, lighting::studio_sky, exact_studio)),
        formula_of(sky_formula("sunset_sky", 286, 0.01, lighting::sunset_sky, exact_sunset)),
    };
}

/// Nodes that hold sqrt(n.v) and the roughness: what is linear between nodes comes out as it went in.
const lighting::BrdfMap& map_of_nodes() {
    static const lighting::BrdfMap map = [] {
        lighting::BrdfMap nodes;
        constexpr int kLast = lighting::kBrdfMapSize - 1;
        for (int j = 0; j <= kLast; ++j) {
            for (int i = 0; i <= kLast; ++i) {
                nodes.texels.insert(nodes.texels.end(), {float(i) / kLast, float(j) / kLast, 0.0f, 0.0f});
            }
        }
        return nodes;
    }();
    return map;
}

/// (a . p) / (1 + b . p) of brdf_fit, the factors in the order of p = 1, x, y, xy, x^2, y^2, x^2 y, x y^2, x^2 y^2.
Real exact_ratio(const std::array<Real, 9>& a, const std::array<Real, 9>& b, Real x, Real y) {
    const std::array<Real, 9> p = {1, x, y, x * y, x * x, y * y, x * x * y, x * y * y, x * x * y * y};
    return std::clamp(std::inner_product(a.begin(), a.end(), p.begin(), Real{0}) /
                          std::inner_product(b.begin(), b.end(), p.begin(), Real{0}),
                      Real{0}, Real{1});
}

std::vector<Formula> formulas_of_fit() {
    return {
        {"brdf_fit",
         "n·v, roughness in [0, 1]: A",
         "[0, 1]",
         0,
         1,
         false,
         1e-5,
         {kCosine, kRoughness},
         [](const Inputs& x) { return lighting::brdf_fit(x[0], x[1]).scale; },
         [](const Inputs& x) {
             return exact_ratio({0.03833L, 2.469L, 10.17L, -27.91L, 14.23L, -9.441L, 26.55L, 43.7L, -44.91L},
                                {1, 0.2998L, 8.603L, -14.86L, 15.39L, -8.769L, 12.39L, 38.77L, -2.377L}, x[0],
                                Real{x[1]} * x[1]);
         }},
        {"brdf_fit",
         "n·v, roughness in [0, 1]: B",
         "[0, 1]",
         0,
         1,
         false,
         1e-5,
         {kCosine, kRoughness},
         [](const Inputs& x) { return lighting::brdf_fit(x[0], x[1]).bias; },
         [](const Inputs& x) {
             return exact_ratio({0.9704L, -2.358L, 7.017L, -14.41L, 1.408L, -3.554L, 7.46L, 6.203L, -2.74L},
                                {1, 1.226L, 23.75L, -110.1L, 11.57L, 96.01L, 235.7L, 576.9L, -835.9L}, x[0],
                                Real{x[1]} * x[1]);
         }},
    };
}

std::vector<Formula> formulas_of_split_sum() {
    return {
        {"look_up_brdf",
         "n·v, roughness in [0, 1]: A of a map of sqrt(n·v)",
         "[0, 1]",
         0,
         1.0000002,
         false,
         4e-7,
         {kCosine, kRoughness},
         [](const Inputs& x) { return lighting::look_up_brdf(map_of_nodes(), x[0], x[1]).scale; },
         [](const Inputs& x) { return std::sqrt(Real{x[0]}); }},
        {"look_up_brdf",
         "n·v, roughness in [0, 1]: B of a map of the roughness",
         "[0, 1]",
         0,
         1.0000002,
         false,
         4e-7,
         {kCosine, kRoughness},
         [](const Inputs& x) { return lighting::look_up_brdf(map_of_nodes(), x[0], x[1]).bias; },
         [](const Inputs& x) { return Real{x[1]}; }},
        {"alpha_of_level",
         "levels 0 to 7",
         "[0, 1]",
         0,
         1,
         false,
         0,
         {{0.0f, 7.99f, Spread::even, {1.0f, 2.0f, 6.0f, 7.0f}}},
         [](const Inputs& x) { return lighting::alpha_of_level(static_cast<int>(x[0])); },
         [](const Inputs& x) { return x[0] < 1 ? Real{0} : std::ldexp(Real{1}, static_cast<int>(x[0]) - 7); }},
        {"level_of_alpha",
         "alpha in [0, 1]",
         "[0, 7]",
         0,
         7,
         false,
         1e-6,
         {{0.0f, 1.0f, Spread::even, {1e-8f, 0.0078125f, 0.015625f}}},
         [](const Inputs& x) { return lighting::level_of_alpha(x[0]); },
         [](const Inputs& x) { return Real{x[0]} < 1 / 64.0L ? Real{x[0]} * 64 : 7 + std::log2(Real{x[0]}); }},
        {"bilinear_tap",
         "fx, fy, share in [0, 1]: weights to the right",
         "[0, 1]",
         0,
         1.0000002,
         false,
         2e-7,
         {{0.0f, 1.0f, Spread::even, {0.5f}}, {0.0f, 1.0f, Spread::even, {0.5f}}, {0.0f, 1.0f, Spread::even, {0.5f}}},
         [](const Inputs& x) {
             const lighting::TexelTap tap = lighting::bilinear_tap(0, 8, x[0], x[1], x[2]);
             return tap.w_10 + tap.w_11;
         },
         [](const Inputs& x) { return Real{x[0]} * x[2]; }},
    };
}

std::vector<Formula> formulas_of_nine_numbers() {
    const Axis height{-1.0f, 1.0f, Spread::even, {0.0f, 1e-8f}};
    return {
        {"sh_polynomials",
         "d unit: the addition theorem's sum",
         "9",
         8.99999,
         9.00001,
         false,
         1e-5,
         {kHeight, kTurn},
         [](const Inputs& x) {
             constexpr double kSquares[] = {1, 3, 3, 3, 15, 15, 1.25, 15, 3.75};  // 4 pi K², Ramamoorthi's constants
             const auto p = lighting::sh_polynomials(direction(x[0], x[1]));
             double sum = 0;
             for (std::size_t k = 0; k < p.size(); ++k) sum += kSquares[k] * p[k] * p[k];
             return sum;
         },
         [](const Inputs&) { return Real{9}; }},
        {"irradiance_of_sh9",
         "l, n unit, the nine numbers of sh9_of_light(l)",
         "[0, 1.0625]",
         0,
         1.0625005,
         false,
         1e-6,
         {height, kAnyTurn, height, kAnyTurn},
         [](const Inputs& x) {
             const lighting::Sh9 nine = lighting::sh9_of_light(direction(x[0], x[1]));
             const vec3 E = lighting::irradiance_of_sh9(nine, direction(x[2], x[3]));
             return (double{E.x} + double{E.y} + double{E.z}) / 3;
         },
         [](const Inputs& x) {  // 1/4 P0 + 1/2 P1 + 5/16 P2 of the angle between them
             const Real c = glm::dot(Wide(direction(x[0], x[1])), Wide(direction(x[2], x[3])));
             return std::max(Real{0}, 0.25L + c / 2 + 5 / 32.0L * (3 * c * c - 1));
         }},
    };
}

}  // namespace

std::vector<Formula> formulas_of_skies() {
    return joined(joined(formulas_of_built_in_skies(), formulas_of_split_sum()),
                  joined(formulas_of_fit(), formulas_of_nine_numbers()));
}

}  // namespace kreda::tests
