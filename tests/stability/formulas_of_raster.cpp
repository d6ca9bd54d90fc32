// The functions of raster/scalar_math.hpp and unit_vector.hpp beside those of the C library in long double.
#include <algorithm>
#include <cmath>

#include "raster/scalar_math.hpp"
#include "raster/unit_vector.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

std::vector<Formula> formulas_of_raster() {
    const Axis share{0.0f, 1.0f, Spread::even, {1e-8f, 0.5f}};
    const Axis length{1e-15f, 1e18f, Spread::logarithmic, {1.0f}};
    return {
        {"exp2",
         "[-126, 127.99]",
         "[1.17e-38, 3.4e38]",
         1.17e-38,
         3.403e38,
         true,
         1e-7,
         {{-126.0f, 127.99f, Spread::even, {-1e-8f, 0.0f, 1e-8f, 1.0f}}},
         [](const Inputs& x) { return raster::exp2(x[0]); },
         [](const Inputs& x) { return std::exp2(Real{x[0]}); }},
        {"exp",
         "[-87.33, 88.72]",
         "[1.17e-38, 3.4e38]",
         1.17e-38,
         3.403e38,
         true,
         1.3e-7,
         {{-87.33f, 88.72f, Spread::even, {-1e-8f, 0.0f, 1e-8f, 1.0f}}},
         [](const Inputs& x) { return raster::exp(x[0]); },
         [](const Inputs& x) { return std::exp(Real{x[0]}); }},
        {"exp",
         "[88.73, 1e30]: is it infinite?",
         "1",
         1,
         1,
         false,
         0,
         {{88.73f, 1e30f, Spread::logarithmic, {}}},
         [](const Inputs& x) { return raster::exp(x[0]) == raster::kInfinity ? 1.0 : 0.0; },
         [](const Inputs&) { return Real{1}; }},
        {"log2",
         "[1.18e-38, 3.4e38]",
         "[-126, 128]",
         -126,
         128,
         true,
         1e-7,
         {{raster::kMinNormal, raster::kMaxFinite, Spread::logarithmic, {1.0f, 2.0f}}},
         [](const Inputs& x) { return raster::log2(x[0]); },
         [](const Inputs& x) { return std::log2(Real{x[0]}); }},
        {"pow",
         "x in [1e-30, 1], y in [0, 1e6]",
         "[0, 1]",
         0,
         1,
         false,
         4e-7,
         {{1e-30f, 1.0f, Spread::logarithmic, {0.5f}}, {0.0f, 1e6f, Spread::even, {1.0f, 2.4f, 64.0f}}},
         [](const Inputs& x) { return raster::pow(x[0], x[1]); },
         [](const Inputs& x) { return std::pow(Real{x[0]}, Real{x[1]}); }},
        {"smooth_ramp",
         "t in [0, 1]",
         "[0, 1]",
         0,
         1,
         false,
         2e-7,
         {share},
         [](const Inputs& x) { return raster::smooth_ramp(x[0]); },
         [](const Inputs& x) { return Real{x[0]} * x[0] * (3 - 2 * Real{x[0]}); }},
        {"unit",
         "components whose largest is in [1e-15, 1e18]: the length of the result",
         "[0.9999996, 1.0000004]",
         0.9999996,
         1.0000004,
         false,
         4e-7,
         {length, length, length},
         [](const Inputs& x) {
             const glm::vec3 v = raster::unit({x[0], x[1], x[2]});
             return static_cast<float>(std::sqrt(Real{v.x} * v.x + Real{v.y} * v.y + Real{v.z} * v.z));
         },
         [](const Inputs&) { return Real{1}; }},
    };
}

}  // namespace kreda::tests
