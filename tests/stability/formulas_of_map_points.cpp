// From a point to its place on a shadow map, shadows/map_point.hpp, in long double.
#include <algorithm>
#include <cmath>

#include "tests/stability/exact_bias.hpp"

namespace kreda::tests {

namespace {

using namespace kreda::shadows;

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
        {"picture_scale",
         "1 to 16384 texels: half of them",
         "[1/2, 8192]",
         0.5,
         8192,
         true,
         0,
         {side},
         [=](const Inputs& x) {
             return scale_of({1.0f, x[0]}).half_side;
         },
         [](const Inputs& x) { return static_cast<int>(x[0]) / Real{2}; }},
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

std::vector<Formula> formulas_of_map_points() {
    return formulas_of_places();
}

}  // namespace kreda::tests
