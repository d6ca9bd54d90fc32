// raster/depth.hpp, depth_formats.hpp, screen.hpp and trigonometry.hpp beside the same in long double.
#include <algorithm>
#include <cmath>
#include <limits>

#include "raster/camera.hpp"
#include "raster/depth.hpp"
#include "raster/depth_formats.hpp"
#include "raster/screen.hpp"
#include "raster/trigonometry.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

namespace {

using raster::DepthFormat;

/// near, then how many times as far the far plane is; the surface lies between them.
const Axis kNear{1e-3f, 1e3f, Spread::logarithmic, {1.0f}};
const Axis kFarByNear{1.001f, 1e9f, Spread::logarithmic, {1e3f, 1e6f}};
const Axis kBetween{0.0f, 1.0f, Spread::even, {1e-8f, 0.5f}};
const std::vector<Axis> kPlanes = {kNear, kFarByNear, kBetween};

struct Planes {
    double n, f, z;
};
Planes planes_of(const Inputs& x) {
    const double n = x[0], f = n * x[1];
    return {n, f, n + x[2] * (f - n)};
}
Real exact_depth(const Inputs& x) {
    const auto [n, f, z] = planes_of(x);
    return Real{f} * (Real{z} - n) / (Real{z} * (Real{f} - n));
}
Real exact_reversed(const Inputs& x) {
    const auto [n, f, z] = planes_of(x);
    return Real{n} * (Real{f} - z) / (Real{z} * (Real{f} - n));
}

std::vector<Formula> depth_formulas() {
    const auto stored = [](DepthFormat format) {
        return [format](const Inputs& x) {
            const auto [n, f, z] = planes_of(x);
            return raster::stored_depth(format, z, n, f);
        };
    };
    const std::string domain = "0.001 <= n <= 1000, f / n in [1.001, 1e9], z between them";
    return {
        {"window_depth", domain, "[0, 1]", 0, 1.0000000000000004, false, 1e-15, kPlanes,
         [](const Inputs& x) { return raster::window_depth(planes_of(x).z, planes_of(x).n, planes_of(x).f); },
         exact_depth},
        {"reversed_depth", domain, "[0, 1]", 0, 1.0000000000000004, false, 1e-15, kPlanes,
         [](const Inputs& x) { return raster::reversed_depth(planes_of(x).z, planes_of(x).n, planes_of(x).f); },
         exact_reversed},
        {"stored_depth", domain + ": 24 bits", "[0, 1]", 0, 1, false, 3.1e-8, kPlanes, stored(DepthFormat::unorm24),
         exact_depth},
        {"stored_depth", domain + ": reversed float", "[0, 1]", 0, 1, true, 1e-7, kPlanes,
         stored(DepthFormat::reversed_float32), exact_reversed, 1e-30},
        {"depth_step", "0.001 <= n <= 1000, f / n in [1.001, 1e9], z between them: 16 bits", "[0, 1.6e16]", 0, 1.6e16,
         true, 1e-14, kPlanes,
         [](const Inputs& x) {
             const auto [n, f, z] = planes_of(x);
             return raster::depth_step(DepthFormat::unorm16, z, n, f);
         },
         [](const Inputs& x) {
             const auto [n, f, z] = planes_of(x);
             return Real{z} * z * (Real{f} - n) / (Real{f} * n) / 65535;
         }},
        {"depth_step", domain + ": float", "[0, 1.3e14]", 0, 1.3e14, true, 1e-14, kPlanes,
         [](const Inputs& x) {
             const auto [n, f, z] = planes_of(x);
             return raster::depth_step(DepthFormat::float32, z, n, f);
         },
         [stored](const Inputs& x) {  // the last of a float's 24 bits
             const auto [n, f, z] = planes_of(x);
             int exponent = -125;
             const double depth = stored(DepthFormat::float32)(x);
             if (depth > 0.0) (void)std::frexp(depth, &exponent);
             return std::ldexp(Real{1}, exponent - 24) * z * z * (Real{f} - n) / (Real{f} * n);
         }},
    };
}

/// A sloping triangle that covers most of an image of 16384 x 16384 samples.
raster::DepthPlane sloping_plane() {
    const raster::ScreenVertex a{0, 0, 0.0f, 1.0f}, b{16384 * 256, 0, 1.0f, 1.0f}, c{0, 16384 * 256, 0.5f, 1.0f};
    return raster::depth_plane(a, b, c, 16384.0 * 256 * 16384 * 256);
}

std::vector<Formula> screen_formulas() {
    const Axis side{1.0f, 16384.0f, Spread::logarithmic, {512.0f}};
    const Axis ndc{-1.0f, 1.0f, Spread::even, {0.0f, 1e-8f}};
    const Axis sample{0.0f, 8191.0f, Spread::even, {1.0f, 4096.0f}};
    return {
        {"window_from_ndc",
         "in [-1, 1], up to 16384 samples: x",
         "[0, 16384]",
         0,
         16384,
         false,
         2e-3,
         {ndc, side},
         [](const Inputs& x) {
             return raster::window_from_ndc(glm::vec3(x[0]), {static_cast<int>(x[1]), 4}).x;
         },
         [](const Inputs& x) { return (Real{x[0]} + 1) * static_cast<int>(x[1]) / 2; }},
        {"guard_band_ndc",
         "1 to 16384 samples: whole samples from the centre",
         "[8191, 16384]",
         8191,
         16384,
         false,
         0,
         {side},
         [](const Inputs& x) { return raster::guard_band_ndc(static_cast<int>(x[0])) * static_cast<int>(x[0]) / 2; },
         [](const Inputs& x) {
             const int samples = static_cast<int>(x[0]);
             return std::exp2(std::floor(std::log2(32766.0L / samples))) * samples / 2;
         }},
        {"depth_of_row",
         "rows in [0, 8191] of a triangle 16384 high, from 0 to 1/2",
         "[0, 0.26]",
         0,
         0.26,
         false,
         1.3e-7,
         {sample},
         [](const Inputs& x) { return raster::depth_of_row(sloping_plane(), static_cast<int>(x[0])); },
         [](const Inputs& x) { return (static_cast<int>(x[0]) + 0.5L) / 32768; }},
        {"depth_at",
         "samples in [0, 8191]² of a triangle 16384 wide, from 0 to 1",
         "[0, 1]",
         0,
         1,
         false,
         2e-7,
         {sample, sample},
         [](const Inputs& x) {
             const raster::DepthPlane plane = sloping_plane();
             return raster::depth_at(plane, raster::depth_of_row(plane, static_cast<int>(x[1])),
                                     static_cast<int>(x[0]));
         },
         [](const Inputs& x) {
             return (static_cast<int>(x[0]) + 0.5L) / 16384 + (static_cast<int>(x[1]) + 0.5L) / 32768;
         }},
        {"aspect_of",
         "1 to 16384 samples a side",
         "[6e-5, 16384]",
         6e-5,
         16384,
         true,
         1e-7,
         {side, side},
         [](const Inputs& x) { return raster::aspect_of(static_cast<int>(x[0]), static_cast<int>(x[1])); },
         [](const Inputs& x) { return Real(static_cast<int>(x[0])) / static_cast<int>(x[1]); }},
    };
}

/// Turns, from the nearest quarter.
Real sine_of_turns(Real turns) {
    return std::sin(2 * kPi * (turns - std::round(turns)));
}

std::vector<Formula> angle_formulas() {
    const Axis turns{-1.0f, 1.0f, Spread::even, {0.0f, 1e-8f, 0.25f, 0.5f}};
    const Axis any{-1e18f, 1e18f, Spread::even, {0.0f, 1e-8f, 1.0f, -1.0f}};
    const Axis near_by{-10.0f, 10.0f, Spread::even, {0.0f, 1e-8f, 1.0f}};
    return {
        {"sin_cos_of_turns",
         "turns in [-1, 1]: sine",
         "[-1, 1]",
         -1,
         1,
         false,
         2e-7,
         {turns},
         [](const Inputs& x) { return raster::sin_cos_of_turns(x[0]).sin; },
         [](const Inputs& x) { return sine_of_turns(x[0]); }},
        {"sin_cos_of_turns",
         "turns in [-1, 1]: cosine",
         "[-1, 1]",
         -1,
         1,
         false,
         2e-7,
         {turns},
         [](const Inputs& x) { return raster::sin_cos_of_turns(x[0]).cos; },
         [](const Inputs& x) { return sine_of_turns(x[0] + 0.25L); }},
        {"atan2_in_turns",
         "y, x in [-1e18, 1e18]",
         "[-1/2, 1/2]",
         -0.5,
         0.5,
         false,
         1e-7,
         {any, any},
         [](const Inputs& x) { return raster::atan2_in_turns(x[0], x[1]); },
         [](const Inputs& x) { return std::atan2(Real{x[0]}, x[1] == 0.0f ? Real{0} : Real{x[1]}) / (2 * kPi); }},
        {"atan_in_double",
         "[-1, 1]",
         "[-0.786, 0.786]",
         -0.786,
         0.786,
         false,
         1e-15,
         {turns},
         [](const Inputs& x) { return raster::atan_in_double(x[0]); },
         [](const Inputs& x) { return std::atan(Real{x[0]}); }},
        {"cos_of_turns_in_double",
         "turns in [0, 1/2]",
         "[-1, 1]",
         -1,
         1,
         false,
         1e-15,
         {{0.0f, 0.5f, Spread::even, {1e-8f, 0.125f, 0.25f}}},
         [](const Inputs& x) { return raster::cos_of_turns_in_double(x[0]); },
         [](const Inputs& x) { return std::cos(2 * kPi * x[0]); }},
        {"radians",
         "[-10, 10]",
         "[-0.175, 0.175]",
         -0.175,
         0.175,
         true,
         2e-7,
         {near_by},
         [](const Inputs& x) { return raster::radians(x[0]); },
         [](const Inputs& x) { return x[0] * kPi / 180; }},
    };
}

}  // namespace

std::vector<Formula> formulas_of_depth() {
    return joined(depth_formulas(), joined(screen_formulas(), angle_formulas()));
}

}  // namespace kreda::tests
