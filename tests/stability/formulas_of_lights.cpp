// The equations of lighting/light.hpp, fog.hpp and raster/film.hpp as the lecture prints them, in long double.
#include <algorithm>
#include <cmath>
#include <limits>

#include "lighting/fog.hpp"
#include "lighting/light.hpp"
#include "lighting/light_sample.hpp"
#include "raster/film.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

namespace {

using namespace kreda::lighting;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
const Axis kDistance{0.0f, kInfinity, Spread::even, {1e-38f, 1e-8f, 1.0f, 1e8f, 1e18f, 2e19f, 1e38f}};
const Axis kCoefficient{0.0f, 1e6f, Spread::even, {1e-8f, 1.0f}};
const Axis kLength{1e-15f, 1e18f, Spread::logarithmic, {1.0f}};

std::vector<Formula> light_formulas() {
    const Axis distance{1e-15f, 1e18f, Spread::logarithmic, {1e-8f, 1.0f, 1e8f}};
    const Axis cosine{-1.0f, 1.0f, Spread::even, {0.0f, 0.5f}};
    return {
        {"attenuate",
         "coefficients in [0, 1e6], not all 0, d in [1e-15, inf]",
         "[0, 1e30]",
         0,
         1e30 * 1.000001,
         true,
         4e-7,
         {{0.0f, 1e6f, Spread::even, {1e-8f, 1.0f}}, kCoefficient, {1.0f, 1e6f, Spread::even, {}}, distance},
         [](const Inputs& x) {
             return attenuate({x[0], x[1], x[2]}, x[3]);
         },
         [](const Inputs& x) { return 1 / (x[0] + Real{x[1]} * x[3] + Real{x[2]} * x[3] * x[3]); }},
        {"attenuate at infinity",
         "coefficients in [0, 1e6]",
         "[0, 1]",
         0,
         1,
         false,
         1e-7,
         {{1.0f, 1e6f, Spread::even, {}}},
         [](const Inputs& x) {
             return attenuate({x[0], 0.0f, 0.0f}, kInfinity);
         },
         [](const Inputs& x) { return 1 / Real{x[0]}; }},
        {"spot_cone",
         "inner = outer, in [-1, 1]: a sharp edge",
         "0 or 1",
         0,
         1,
         false,
         0,
         {cosine, cosine},
         [](const Inputs& x) { return spot_cone(x[0], x[1], x[1]); },
         [](const Inputs& x) { return x[0] >= x[1] ? Real{1} : Real{0}; }},
        {"spot_cone",
         "all cosines in [-1, 1], inner >= outer + 0.001",
         "[0, 1]",
         0,
         1,
         false,
         2e-4,
         {cosine, {-0.99f, 1.0f, Spread::even, {0.5f}}, {0.001f, 0.01f, Spread::even, {}}},
         [](const Inputs& x) { return spot_cone(x[0], x[1], x[1] - x[2]); },
         [](const Inputs& x) {
             const Real outer = x[1] - x[2];  // rounded to float, as the formula gets it
             const Real t = std::clamp((x[0] - Real(float(outer))) / (x[1] - Real(float(outer))), Real{0}, Real{1});
             return t * t * (3 - 2 * t);
         }},
    };
}

std::vector<Formula> fog_formulas() {
    const Axis far_away{0.0f, 1e18f, Spread::even, {1e-38f, 1e-8f, 1.0f, 100.0f, 1e8f}};
    const Axis near_by{0.0f, 100.0f, Spread::even, {1e-8f, 1.0f}};
    const Axis density{0.0f, 1e30f, Spread::even, {1e-38f, 1e-8f, 0.1f, 1.0f}};
    return {
        {"fog_linear",
         "z >= 0 or infinite, start and end any two numbers up to 1e18",
         "[0, 1]",
         0,
         1,
         false,
         3e-7,
         {far_away, {0.0f, 50.0f, Spread::even, {}}, {50.5f, 1e18f, Spread::even, {100.0f}}},
         [](const Inputs& x) { return fog_linear(x[0], x[1], x[2]); },
         [](const Inputs& x) { return std::clamp((Real{x[2]} - x[0]) / (Real{x[2]} - x[1]), Real{0}, Real{1}); }},
        {"fog_exp",
         "z in [0, inf), density in [0, 1e30]",
         "[0, 1]",
         0,
         1,
         false,
         3e-6,
         {near_by, density},
         [](const Inputs& x) { return fog_exp(x[0], x[1]); },
         [](const Inputs& x) { return std::exp(-Real{x[0]} * x[1]); }},
        {"fog_exp2",
         "z in [0, inf), density in [0, 1e30]",
         "[0, 1]",
         0,
         1,
         false,
         3e-6,
         {near_by, density},
         [](const Inputs& x) { return fog_exp2(x[0], x[1]); },
         [](const Inputs& x) { return std::exp(-(Real{x[0]} * x[1]) * (Real{x[0]} * x[1])); }},
        {"radial_distance",
         "0, or components whose largest is in [1e-15, 1e18]",
         "[0, 1.8e18]",
         0,
         1.8e18,
         true,
         2e-7,
         {kLength, kLength, kLength},
         [](const Inputs& x) {
             return radial_distance({x[0], x[1], x[2]}, glm::vec3(0.0f));
         },
         [](const Inputs& x) { return std::sqrt(Real{x[0]} * x[0] + Real{x[1]} * x[1] + Real{x[2]} * x[2]); }},
    };
}

std::vector<Formula> film_formulas() {
    const Axis radiance{0.0f, kInfinity, Spread::even, {1e-38f, 1e-8f, 0.5f, 1.0f, 100.0f, 1e18f, 1e38f}};
    const Axis middle{0.0f, 100.0f, Spread::even, {1e-8f, 1.0f}};
    const Axis encoded{0.0f, 1.0f, Spread::even, {1e-8f, 0.0031308f, 0.04045f}};
    const Axis white{1e-6f, 1e6f, Spread::logarithmic, {1.0f}};
    return {
        {"reinhard",
         "radiance in [0, inf]",
         "[0, 1]",
         0,
         1,
         false,
         2e-7,
         {middle},
         [](const Inputs& x) { return raster::reinhard(x[0]); },
         [](const Inputs& x) { return x[0] / (1 + Real{x[0]}); }},
        {"reinhard_extended",
         "radiance in [0, inf], white in [1e-6, 1e6]",
         "[0, 1.1e30]",
         0,
         1.1e30,
         true,
         1e-6,
         {middle, white},
         [](const Inputs& x) { return raster::reinhard_extended(x[0], x[1]); },
         [](const Inputs& x) { return x[0] * (1 + x[0] / (Real{x[1]} * x[1])) / (1 + Real{x[0]}); }},
        {"srgb_from_linear",
         "[0, 1]",
         "[0, 1]",
         0,
         1.0000002,
         false,
         4e-7,
         {encoded},
         [](const Inputs& x) { return raster::srgb_from_linear(x[0]); },
         [](const Inputs& x) {
             return x[0] <= 0.0031308f ? Real(12.92L) * x[0] : 1.055L * std::pow(Real{x[0]}, 1 / 2.4L) - 0.055L;
         }},
        {"linear_from_srgb",
         "[0, 1]",
         "[0, 1]",
         0,
         1.0000002,
         false,
         6e-7,
         {encoded},
         [](const Inputs& x) { return raster::linear_from_srgb(x[0]); },
         [](const Inputs& x) { return x[0] <= 0.04045f ? x[0] / 12.92L : std::pow((x[0] + 0.055L) / 1.055L, 2.4L); }},
    };
}

}  // namespace

std::vector<Formula> formulas_of_lights() {
    std::vector<Formula> all = light_formulas();
    for (const std::vector<Formula>& more : {fog_formulas(), film_formulas()}) {
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

}  // namespace kreda::tests
