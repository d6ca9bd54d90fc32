// The bias formulas of shadows/map_point.hpp in long double.
#include <algorithm>
#include <cmath>

#include "shadows/map_point.hpp"
#include "shadows/soft_filter.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

namespace {

using namespace kreda::shadows;

Real limited(Real cosine) {
    const Real size = std::max(std::fabs(cosine), Real(kLeastCosine));
    return cosine < 0 ? -size : size;
}

/// A picture of 90 degrees with 1024 texels a side, and the bias that follows the slope.
const PictureScale kPicture{glm::vec2(2.0f / 1024.0f), glm::vec2(512.0f), 512.0f};
const BiasTerms kSlopeBias{1e-3f, 1.0f, 0.0f, 1.0f};

/// How a surface leans on the map.
std::vector<Formula> formulas_of_slopes() {
    const Axis cosine{-1.0f, 1.0f, Spread::even, {-1e-8f, 0.0f, 1e-8f, 0.01f}};
    const Axis texel{1e-18f, 1e18f, Spread::logarithmic, {1.0f}};
    return {
        {"steepness_limit",
         "cosine in [-1, 1]",
         "[-1, 1] without (-0.01, 0.01)",
         -1,
         1,
         false,
         0,
         {cosine},
         [](const Inputs& x) { return steepness_limit(x[0]); },
         [](const Inputs& x) { return limited(x[0]); }},
        {"slope_parallel",
         "length of n up to 1, texel in [1e-18, 1e18]: its u",
         "[-1e20, 1e20]",
         -1.0001e20,
         1.0001e20,
         true,
         3e-7,
         {cosine, cosine, texel},
         [](const Inputs& x) {
             return slope_parallel({x[0], 0.0f, x[1]}, glm::vec2(x[2])).u;
         },
         [](const Inputs& x) { return x[0] / limited(x[1]) * x[2]; }},
        {"least_normal_offset",
         "length of n up to 1, texel in [1e-18, 1e18]",
         "[0, 1e18]",
         0,
         1.0001e18,
         true,
         3e-7,
         {cosine, cosine, texel},
         [](const Inputs& x) {
             return least_normal_offset({x[0], x[1], 0.0f}, glm::vec2(x[2]));
         },
         [](const Inputs& x) { return (std::fabs(Real{x[0]}) + std::fabs(Real{x[1]})) * x[2] / 2; }},
    };
}

/// The soft edge, the bias and the place on the map.
std::vector<Formula> formulas_of_maps() {
    const Axis cosine{-1.0f, 1.0f, Spread::even, {-1e-8f, 0.0f, 1e-8f, 0.01f}};
    const Axis place{-1.0f, 1.0f, Spread::even, {0.0f, 1e-8f}};
    const Axis distance{1e-3f, 1e6f, Spread::logarithmic, {1.0f}};
    const Axis big{1e-15f, 1e18f, Spread::logarithmic, {1.0f}};
    const auto slope_u = [](Real n_u, Real n_z, Real at_u, Real far_away) {
        const Real of_ray = -(n_u * at_u - n_z * far_away) / far_away;
        return n_u * far_away / limited(of_ray) * kPicture.texel.x;
    };
    return {
        {"half_cone",
         "half width in [0, 1e6], receiver >= blocker in [0.001, 1e6]",
         "[0, 1e9]",
         0,
         1e9,
         true,
         4e-7,
         {{0.0f, 1e6f, Spread::even, {1.0f}}, distance, {1.0f, 1e3f, Spread::logarithmic, {2.0f}}},
         [](const Inputs& x) { return half_cone(x[0], x[1] * x[2], x[1], true); },
         [](const Inputs& x) {
             const Real receiver = x[1] * x[2];
             return x[0] * (receiver - x[1]) / (receiver * x[1]);
         }},
        {"least_bias",
         "slopes in [1e-15, 1e18]",
         "[0, 1e18]",
         0,
         1.0000001e18,
         true,
         1.3e-7,
         {big, big},
         [](const Inputs& x) {
             return least_bias({x[0], -x[1]});
         },
         [](const Inputs& x) { return (Real{x[0]} + x[1]) / 2; }},
        {"offset_factor",
         "cosine in [-1, 1], a normal offset of 2 and a slope of 1",
         "[-3, 2]",
         -3,
         2,
         false,
         0,
         {cosine},
         [](const Inputs& x) {
             return offset_factor({0.0f, 1.0f, 2.0f, 0.0f}, x[0]);
         },
         [](const Inputs& x) { return x[0] < 0.0f ? Real{-3} : Real{2}; }},
        {"slope_factor",
         "cosine in [-1, 1], a slope of 1",
         "[0, 1]",
         0,
         1,
         false,
         0,
         {cosine},
         [](const Inputs& x) { return slope_factor(kSlopeBias, x[0]); },
         [](const Inputs& x) { return x[0] < 0.0f ? Real{0} : Real{1}; }},
        {"slope_perspective",
         "n unit, the point in a picture of 90°, distance in [0.001, 1e6]: u in distances",
         "[-0.2, 0.2]",
         -0.21,
         0.21,
         false,
         3e-5,
         {kHeight, {0.1f, 1.0f, Spread::even, {}}, distance},
         [](const Inputs& x) {
             const glm::vec3 n = direction(x[0], 0.0f), q{x[1] * x[2], 0.0f, -x[2]};
             return slope_perspective(n, q, x[2], kPicture.texel).u / x[2];
         },
         [=](const Inputs& x) {
             const glm::vec3 n = direction(x[0], 0.0f);
             return slope_u(n.x, n.z, Real{x[1] * x[2]}, x[2]) / x[2];
         }},
        {"map_point_perspective",
         "the point in a picture of 90° and 1024 texels, distance in [0.001, 1e6]: u",
         "[0, 1024]",
         0,
         1024,
         false,
         1.3e-4,
         {place, distance},
         [](const Inputs& x) {
             return map_point_perspective({x[0] * x[1], 0.0f, -x[1]}, {0.0f, 0.0f, 1.0f}, kPicture, kSlopeBias).u;
         },
         [](const Inputs& x) { return Real{x[0] * x[1]} / x[1] * 512 + 512; }},
        {"map_steps_parallel",
         "the point in a picture 2 wide with 1024 texels: u",
         "[0, 1024]",
         0,
         1024,
         false,
         1.3e-4,
         {place},
         [](const Inputs& x) {
             return map_steps_parallel({x[0], 0.0f, 0.5f}, {0.0f, 0.0f, 1.0f}, kPicture, kSlopeBias).point.u;
         },
         [](const Inputs& x) { return x[0] * Real{512} + 512; }},
        {"map_point_parallel",
         "n·l in [-1, 1], distance in [0.001, 1e6]: the biased distance",
         "[0, 1e6]",
         -0.2,
         1e6,
         false,
         0.07,
         {kHeight, distance},
         [](const Inputs& x) {
             const glm::vec3 n = direction(x[0], 0.0f);
             return map_point_parallel({0.0f, 0.0f, -x[1]}, n, kPicture, kSlopeBias).distance;
         },
         [](const Inputs& x) {
             const glm::vec3 n = direction(x[0], 0.0f);
             const Real slope = std::fabs(n.x / limited(n.z) * kPicture.texel.x);
             return x[1] - Real{1e-3f} - (n.z < 0.0f ? 0 : slope / 2);
         }},
    };
}

/// The rest of the way from a point to its texel.
std::vector<Formula> formulas_of_places() {
    const Axis place{-1.0f, 1.0f, Spread::even, {0.0f, 1e-8f}};
    const Axis distance{1e-3f, 1e6f, Spread::logarithmic, {1.0f}};
    const Axis half_size{1e-3f, 1e6f, Spread::logarithmic, {1.0f}};
    const Axis side{1.0f, 16384.0f, Spread::logarithmic, {1024.0f}};
    const BiasTerms offset_bias{0.0f, 0.0f, 2.0f, 0.0f};
    const glm::vec3 up{0.0f, 0.0f, 1.0f};
    const auto scale_of = [](const Inputs& x) {
        LightView view;
        view.half_size = glm::vec2(x[0]);
        return picture_scale(view, static_cast<int>(x[1]));
    };
    const auto world_point = [](const Inputs& x) { return direction(x[0], x[1]) * x[2]; };
    return {
        {"picture_scale",
         "half size in [0.001, 1e6], 1 to 16384 texels: a texel's width",
         "[1e-7, 2e6]",
         1e-7,
         2.1e6,
         true,
         2e-7,
         {half_size, side},
         [=](const Inputs& x) { return scale_of(x).texel.x; },
         [](const Inputs& x) { return 2 * Real{x[0]} / static_cast<int>(x[1]); }},
        {"picture_scale",
         "half size in [0.001, 1e6], 1 to 16384 texels: texels a unit",
         "[5e-7, 1e7]",
         4e-7,
         1e7,
         true,
         2e-7,
         {half_size, side},
         [=](const Inputs& x) { return scale_of(x).texels_per_unit.y; },
         [](const Inputs& x) { return static_cast<int>(x[1]) / (2 * Real{x[0]}); }},
        {"map_point_parallel",
         "the point in a picture 2 wide with 1024 texels: v",
         "[0, 1024]",
         0,
         1024,
         false,
         1.3e-4,
         {place},
         [=](const Inputs& x) {
             return map_point_parallel({0.0f, x[0], 0.5f}, up, kPicture, kSlopeBias).v;
         },
         [](const Inputs& x) { return 512 - x[0] * Real{512}; }},
        {"map_point_perspective",
         "the point in a picture of 90° and 1024 texels, distance in [0.001, 1e6]: v",
         "[0, 1024]",
         0,
         1024,
         false,
         1.3e-4,
         {place, distance},
         [=](const Inputs& x) {
             return map_point_perspective({0.0f, x[0] * x[1], -x[1]}, up, kPicture, kSlopeBias).v;
         },
         [](const Inputs& x) { return 512 - Real{x[0] * x[1]} / x[1] * 512; }},
        {"map_point_perspective",
         "n·l in [0.1, 1], distance in [1, 1000]: the biased distance",
         "[0, 1000]",
         0,
         1000,
         false,
         2e-4,
         {{0.1f, 1.0f, Spread::even, {}}, {1.0f, 1e3f, Spread::logarithmic, {}}},
         [](const Inputs& x) {
             return map_point_perspective({0.0f, 0.0f, -x[1]}, direction(x[0], 0.0f), kPicture, kSlopeBias).distance;
         },
         [](const Inputs& x) {
             const glm::vec3 n = direction(x[0], 0.0f);
             return x[1] - Real{1e-3f} - std::fabs(Real{n.x}) * x[1] / limited(n.z) * kPicture.texel.x / 2;
         }},
        {"map_steps_perspective",
         "n·l in [0.1, 1], distance in [1, 1000], 2 least offsets along the normal: the offset",
         "[0, 4]",
         0,
         4,
         true,
         3e-7,
         {{0.1f, 1.0f, Spread::even, {}}, {1.0f, 1e3f, Spread::logarithmic, {}}},
         [=](const Inputs& x) {
             return map_steps_perspective({0.0f, 0.0f, -x[1]}, direction(x[0], 0.0f), kPicture, offset_bias).offset;
         },
         [](const Inputs& x) { return std::fabs(Real{direction(x[0], 0.0f).x}) * kPicture.texel.x * x[1]; }},
        {"bias_terms",
         "depth range in [0.001, 1e6], the bias by slope: its constant and its slope",
         "[0, 1e6]",
         0,
         1.1e6,
         true,
         2e-7,
         {distance},
         [](const Inputs& x) {
             ShadowSettings settings;
             settings.bias = ShadowBias::slope;
             settings.constant_bias = 0.5f;
             settings.slope_bias = 3.0f;
             const BiasTerms bias = bias_terms(settings, x[0]);
             return bias.constant + bias.slope + bias.normal_offset + bias.follow_plane;
         },
         [](const Inputs& x) { return Real{x[0]} / 2 + 4; }},
        formula_of({"point_in_picture",
                    "a light at (1, 2, 3), its axes the world's: the point",
                    "[0, 1.1e6]",
                    1.1e6,
                    false,
                    0.2,
                    {kHeight, kTurn, distance},
                    [=](const Inputs& x) {
                        return point_in_picture(glm::mat3(1.0f), {1.0f, 2.0f, 3.0f}, world_point(x), up).q;
                    },
                    [=](const Inputs& x) { return Wide(world_point(x)) - Wide(1, 2, 3); }}),
        formula_of({"point_in_cube",
                    "a light at (1, 2, 3), the point to its right: as seen by the face",
                    "[0, 2.5e6]",
                    2.5e6,
                    false,
                    0.2,
                    {distance, place, place},
                    [](const Inputs& x) {
                        return point_in_cube({1.0f, 2.0f, 3.0f},
                                             {1.0f + 2.0f * x[0], 2.0f + x[1] * x[0], 3.0f + x[2] * x[0]}, {0, 0, 1})
                            .q;
                    },
                    [](const Inputs& x) { return Wide(Real{x[2] * x[0]}, Real{x[1] * x[0]}, -2 * Real{x[0]}); }}),
    };
}

}  // namespace

std::vector<Formula> formulas_of_shadows() {
    return joined(joined(formulas_of_slopes(), formulas_of_maps()), joined(formulas_of_places(), formulas_of_rays()));
}

}  // namespace kreda::tests
