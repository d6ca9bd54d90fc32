// raster/texture.hpp and the rest of scalar_math.hpp beside the same in long double.
#include <algorithm>
#include <cmath>
#include <limits>

#include "raster/scalar_math.hpp"
#include "raster/tangents.hpp"
#include "raster/texture.hpp"
#include "raster/unit_vector.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

namespace {

using raster::TextureWrap;

/// 4 x 2 texels 0, 1/8, ..., row by row from the top, and its pyramid.
const raster::Texture& eighths_texture() {
    static const raster::Texture texture = [] {
        raster::Image image = raster::make_image(4, 2, 1);
        for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = static_cast<float>(i) / 8.0f;
        return raster::make_texture(image);
    }();
    return texture;
}

/// Clamped bilinear look-up of a level whose texel (x, y) is `texel`.
template <class Texel>
Real exact_bilinear(Real u, Real v, int width, int height, Texel texel) {
    const auto along = [](Real t, int side) { return std::clamp(t * side - 0.5L, Real{0}, Real(side - 1)); };
    const Real x = along(u, width), y = along(1 - v, height);
    const int left = std::min(static_cast<int>(x), std::max(width - 2, 0)), right = std::min(left + 1, width - 1);
    const int top = std::min(static_cast<int>(y), std::max(height - 2, 0)), below = std::min(top + 1, height - 1);
    const Real t = x - left, s = y - top;
    return (1 - s) * ((1 - t) * texel(left, top) + t * texel(right, top)) +
           s * ((1 - t) * texel(left, below) + t * texel(right, below));
}
Real exact_fine(Real u, Real v) {
    return exact_bilinear(u, v, 4, 2, [](int x, int y) { return Real(4 * y + x) / 8; });
}
/// Means of 2 x 2 texels: 5/16 (0, 1, 4, 5 eighths) and 9/16.
Real exact_coarse(Real u, Real v) {
    return exact_bilinear(u, v, 2, 1, [](int x, int) { return x == 0 ? 10 / 32.0L : 18 / 32.0L; });
}

std::vector<Formula> texture_formulas() {
    const Axis u{0.0f, 1.0f, Spread::even, {1e-8f, 0.25f, 0.5f}};
    const Axis any_u{-1e6f, 1e6f, Spread::even, {0.0f, -1e-8f, 1.0f, 0.5f}};
    const Axis level{0.0f, 1.0f, Spread::even, {1e-8f, 0.5f}};
    const Axis step{1e-6f, 1e6f, Spread::logarithmic, {1.0f}};
    const auto view = [] { return raster::view_of(eighths_texture(), TextureWrap::clamp); };
    return {
        {"wrapped",
         "u in [-1e6, 1e6]: repeat",
         "[0, 1]",
         0,
         1,
         false,
         1e-7,
         {any_u},
         [](const Inputs& x) { return raster::wrapped(x[0], TextureWrap::repeat); },
         [](const Inputs& x) { return Real{x[0]} - std::floor(Real{x[0]}); }},
        {"mix_texels",
         "a, b, t in [0, 1]",
         "[0, 1]",
         0,
         1.0000002,
         false,
         1.3e-7,
         {u, u, u},
         [](const Inputs& x) { return raster::mix_texels(x[0], x[1], x[2]); },
         [](const Inputs& x) { return x[0] + Real{x[2]} * (Real{x[1]} - x[0]); }},
        {"sample_nearest",
         "u, v in [0, 1], 4 x 2 texels",
         "[0, 1]",
         0,
         1,
         false,
         0,
         {u, u},
         [=](const Inputs& x) { return raster::sample_nearest(view(), x[0], x[1], 0); },
         [](const Inputs& x) {
             const int column = std::min(static_cast<int>(x[0] * Real{4}), 3),
                       row = 1 - std::min(static_cast<int>(x[1] * Real{2}), 1);
             return Real(4 * row + column) / 8;
         }},
        {"sample_bilinear",
         "u, v in [0, 1], 4 x 2 texels, clamped",
         "[0, 1]",
         0,
         1,
         false,
         5e-7,
         {u, u},
         [=](const Inputs& x) { return raster::sample_bilinear(view(), x[0], x[1], 0); },
         [](const Inputs& x) { return exact_fine(x[0], x[1]); }},
        {"sample_level",
         "u, v in [0, 1], level 1 of 4 x 2 texels, clamped",
         "[0, 1]",
         0,
         1,
         false,
         5e-7,
         {u, u},
         [=](const Inputs& x) { return raster::sample_level(view(), x[0], x[1], 1, 0); },
         [](const Inputs& x) { return exact_coarse(x[0], x[1]); }},
        {"sample_trilinear",
         "u, v, level in [0, 1], 4 x 2 texels, clamped",
         "[0, 1]",
         0,
         1,
         false,
         6e-7,
         {u, u, level},
         [=](const Inputs& x) { return raster::sample_trilinear(view(), x[0], x[1], x[2], 0); },
         [](const Inputs& x) { return (1 - Real{x[2]}) * exact_fine(x[0], x[1]) + x[2] * exact_coarse(x[0], x[1]); }},
        {"level_of_detail",
         "steps in [1e-6, 1e6], 4096 x 4096 texels",
         "[-63, 64]",
         -63,
         64,
         false,
         4e-6,
         {step, step},
         [](const Inputs& x) {
             return raster::level_of_detail({x[0], 0.0f}, {0.0f, x[1]}, 4096, 4096);
         },
         [](const Inputs& x) { return std::log2(std::max(Real{x[0]}, Real{x[1]}) * 4096); }},
    };
}

std::vector<Formula> parts_of_scalar_functions() {
    const Axis share{0.0f, 1.0f, Spread::even, {1e-8f, 0.5f}};
    const Axis any{-1e30f, 1e30f, Spread::even, {0.0f, 1e-8f, 1.0f, -1e-7f}};
    const Axis whole{-100.0f, 100.0f, Spread::even, {0.0f, 1.0f}};
    const Axis fraction{-0.5f, 0.5f, Spread::even, {0.0f, 1e-8f}};
    const Axis exponent{-100.0f, 100.0f, Spread::even, {0.0f, 1.0f}};
    const Axis length{1e-15f, 1e18f, Spread::logarithmic, {1.0f}};
    return {
        {"smaller_of_positive",
         "a, b in [0, inf)",
         "[0, inf)",
         0,
         3.5e38,
         false,
         0,
         {{0.0f, raster::kMaxFinite, Spread::even, {1e-38f, 1.0f}}, {0.0f, raster::kMaxFinite, Spread::even, {1.0f}}},
         [](const Inputs& x) { return raster::smaller_of_positive(x[0], x[1]); },
         [](const Inputs& x) { return std::min(Real{x[0]}, Real{x[1]}); }},
        {"saturate",
         "[-1e30, 1e30]",
         "[0, 1]",
         0,
         1,
         false,
         0,
         {any},
         [](const Inputs& x) { return raster::saturate(x[0]); },
         [](const Inputs& x) { return std::clamp(Real{x[0]}, Real{0}, Real{1}); }},
        {"lerp",
         "a, b, t in [0, 1]",
         "[0, 1]",
         0,
         1.0000002,
         false,
         1.5e-7,
         {share, share, share},
         [](const Inputs& x) { return raster::lerp(x[0], x[1], x[2]); },
         [](const Inputs& x) { return (1 - Real{x[2]}) * x[0] + Real{x[2]} * x[1]; }},
        {"scale_by_power_of_two",
         "p in [0.5, 2], n in [-100, 100]",
         "[3e-31, 2.6e30]",
         3e-31,
         2.6e30,
         true,
         0,
         {{0.5f, 2.0f, Spread::even, {1.0f}}, whole},
         [](const Inputs& x) {
             return raster::scale_by_power_of_two(x[0], static_cast<std::uint32_t>(static_cast<std::int32_t>(x[1])));
         },
         [](const Inputs& x) { return std::ldexp(Real{x[0]}, static_cast<int>(x[1])); }},
        {"exp2_of_fraction",
         "[-1/2, 1/2]",
         "[0.707, 1.4143]",
         0.707,
         1.4143,
         true,
         1e-7,
         {fraction},
         [](const Inputs& x) { return raster::exp2_of_fraction(x[0]); },
         [](const Inputs& x) { return std::exp2(Real{x[0]}); }},
        {"exp2_of_sum",
         "x in [-100, 100], its low part in [-1e-6, 1e-6]",
         "[7e-31, 1.3e30]",
         7e-31,
         1.3e30,
         true,
         1.3e-7,
         {exponent, {-1e-6f, 1e-6f, Spread::even, {0.0f}}},
         [](const Inputs& x) { return raster::exp2_of_sum(x[0], x[1]); },
         [](const Inputs& x) { return std::exp2(Real{x[0]} + x[1]); }},
        {"log2_in_double",
         "[1.18e-38, 3.4e38]",
         "[-126, 128]",
         -126,
         128,
         true,
         1.5e-8,
         {{raster::kMinNormal, raster::kMaxFinite, Spread::logarithmic, {1.0f, 2.0f}}},
         [](const Inputs& x) { return raster::log2_in_double(x[0]); },
         [](const Inputs& x) { return std::log2(Real{x[0]}); }},
        {"pow_from_log2",
         "log2 of the result in [-100, 100]",
         "[7e-31, 1.3e30]",
         7e-31,
         1.3e30,
         true,
         1.3e-7,
         {exponent},
         [](const Inputs& x) {
             return raster::pow_from_log2({x[0], 0.0f}, 1.0f);
         },
         [](const Inputs& x) { return std::exp2(Real{x[0]}); }},
        {"round_half_up_to_int",
         "[-1e6, 1e6]",
         "[-1e6, 1e6]",
         -1e6,
         1e6,
         false,
         0,
         {{-1e6f, 1e6f, Spread::even, {0.5f, -0.5f, 2.5f, -2.5f, 0.49999997f}}},
         [](const Inputs& x) { return raster::round_half_up_to_int(x[0]); },
         [](const Inputs& x) { return std::floor(Real{x[0]} + 0.5L); }},
        {"divisible_length",
         "components whose largest is in [1e-15, 1e18]",
         "[1e-15, 1.8e18]",
         9.99e-16,
         1.8e18,
         true,
         2e-7,
         {length, length, length},
         [](const Inputs& x) {
             return raster::divisible_length({x[0], x[1], x[2]});
         },
         [](const Inputs& x) { return std::max(glm::length(Wide(x[0], x[1], x[2])), Real{1e-15f}); }},
        {"any_perpendicular",
         "n unit: its cosine with n",
         "[-1e-15, 1e-15]",
         -1e-15,
         1e-15,
         false,
         1e-15,
         {kHeight, kTurn},
         [](const Inputs& x) {
             const glm::dvec3 n = glm::normalize(glm::dvec3(direction(x[0], x[1])));
             return glm::dot(raster::any_perpendicular(n), n);
         },
         [](const Inputs&) { return Real{0}; }},
    };
}

}  // namespace

std::vector<Formula> formulas_of_textures() {
    return joined(texture_formulas(), parts_of_scalar_functions());
}

}  // namespace kreda::tests
