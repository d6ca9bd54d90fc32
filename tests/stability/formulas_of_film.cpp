// raster/film.hpp in long double: tone mapping and transfer function, each alone and together.
#include <algorithm>
#include <cmath>
#include <limits>

#include "raster/film.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

namespace {

/// L / (1 + L), which is 1 at infinity.
Real exact_reinhard(Real radiance) {
    return std::isinf(radiance) ? Real{1} : radiance / (1 + radiance);
}

Real exact_srgb(Real x) {
    return x <= Real{0.0031308f} ? Real(12.92L) * x : 1.055L * std::pow(x, 1 / 2.4L) - 0.055L;
}

std::vector<Formula> film_formulas() {
    const Axis radiance{1e-30f, 1e38f, Spread::logarithmic, {0.5f, 1.0f, 100.0f, 1e18f}, {0.0f, raster::kInfinity}};
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
         {radiance},
         [](const Inputs& x) { return raster::reinhard(x[0]); },
         [](const Inputs& x) { return exact_reinhard(x[0]); }},
        {"reinhard_extended",
         "radiance in [0, inf], white in [1e-6, 1e6]",
         "[0, 1.1e30]",
         0,
         1.1e30,
         true,
         1e-6,
         {radiance, white},
         [](const Inputs& x) { return raster::reinhard_extended(x[0], x[1]); },
         [](const Inputs& x) {
             const Real safe = std::min(x[0], 1e18f);
             return exact_reinhard(safe) * (1 + safe / (Real{x[1]} * x[1]));
         }},
        {"srgb_from_linear",
         "[0, 1]",
         "[0, 1]",
         0,
         1.0000002,
         false,
         4e-7,
         {encoded},
         [](const Inputs& x) { return raster::srgb_from_linear(x[0]); },
         [](const Inputs& x) { return exact_srgb(x[0]); }},
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

/// All of it, for what no display can show, too: NaN counts as 0, what is negative as 0, infinity as the brightest.
std::vector<Formula> whole_film() {
    static const float kOdd[] = {std::numeric_limits<float>::quiet_NaN(),
                                 -raster::kInfinity,
                                 -1e38f,
                                 -18.6f,
                                 -1e-38f,
                                 0.0f,
                                 1e-38f,
                                 0.18f,
                                 1e38f,
                                 raster::kInfinity};
    const auto radiance_of = [](const Inputs& x) { return x[1] < 1.0f ? x[0] : kOdd[static_cast<int>(x[1]) - 1]; };
    const auto settings_of = [](const Inputs& x) {
        raster::FilmSettings settings;
        settings.tone_map = x[2] < 1.0f ? raster::ToneMap::none : raster::ToneMap::reinhard;
        return settings;
    };
    return {
        {"display_value",
         "radiance in [0, 1e18], or NaN, negative to -1e38 and -inf, 1e38, inf; tone map none or reinhard",
         "[0, 1]",
         0,
         1,
         false,
         4e-7,
         {{1e-8f, 1e18f, Spread::logarithmic, {1.0f}, {0.0f}},
          {0.0f, 10.0f, Spread::even, {1, 2, 3, 4, 5, 6, 7, 8, 9}},
          {0.0f, 1.0f, Spread::even, {}}},
         [=](const Inputs& x) { return raster::display_value(radiance_of(x), settings_of(x)); },
         [=](const Inputs& x) {
             const float radiance = radiance_of(x);
             const Real light = radiance > 0.0f ? Real{radiance} : Real{0};
             const bool is_plain = settings_of(x).tone_map == raster::ToneMap::none;
             return exact_srgb(is_plain ? std::min(light, Real{1}) : exact_reinhard(light));
         }},
    };
}

}  // namespace

std::vector<Formula> formulas_of_film() {
    return joined(film_formulas(), whole_film());
}

}  // namespace kreda::tests
