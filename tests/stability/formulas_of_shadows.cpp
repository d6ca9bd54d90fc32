// The bias formulas of shadows/map_point.hpp in long double.
#include <algorithm>
#include <cmath>

#include "shadows/light_ray.hpp"
#include "shadows/map_point.hpp"
#include "shadows/planar.hpp"
#include "shadows/soft_filter.hpp"
#include "shadows/volume.hpp"
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

/// What the exact methods share, in double.
std::vector<Formula> formulas_of_rays() {
    const Axis place{-1e3f, 1e3f, Spread::even, {0.0f, 1.0f}};
    const Triangle triangle{{0.0f, 0.0f, 1.0f}, {1.0f, 0.0f, 1.5f}, {0.0f, 1.0f, 2.0f}};
    const auto ray_from = [](const Inputs& x) {
        return light_ray(glm::dvec4(0.25, 0.25, 10.0, 1.0), {x[0], x[1], -5.0f});
    };
    const auto exact_hit = [=](const Inputs& x) {
        const Wide p(x[0], x[1], -5.0L), to_light = Wide(0.25L, 0.25L, 10.0L) - p, a(triangle.a);
        const Wide normal = glm::cross(Wide(triangle.b) - a, Wide(triangle.c) - a);
        return glm::dot(normal, a - p) / glm::dot(normal, to_light);
    };
    return {
        {"toward_light",
         "light and point in [-1000, 1000]: x",
         "[-2000, 2000]",
         -2000,
         2000,
         false,
         3e-13,
         {place, place},
         [](const Inputs& x) { return toward_light(glm::dvec4(x[0], 0, 0, 1), glm::dvec3(x[1], 0, 0)).x; },
         [](const Inputs& x) { return Real{x[0]} - x[1]; }},
        {"homogeneous",
         "a directional light, its direction unit: z",
         "[-1, 1]",
         -1,
         1,
         false,
         0,
         {kHeight},
         [](const Inputs& x) {
             ShadowLight light;
             light.direction = direction(x[0], 0.0f);
             return homogeneous(light).z;
         },
         [](const Inputs& x) { return -Real{x[0]}; }},
        {"largest_coordinate",
         "[-1000, 1000]",
         "[0, 1000]",
         0,
         1000,
         false,
         0,
         {place, place},
         [](const Inputs& x) {
             return largest_coordinate({x[0], x[1], 0.0f});
         },
         [](const Inputs& x) { return std::max(std::fabs(Real{x[0]}), std::fabs(Real{x[1]})); }},
        {"sheared",
         "points in [-1000, 1000]: beside the ray",
         "[0, 3000]",
         0,
         3000,
         false,
         1e-12,
         {place, place},
         [=](const Inputs& x) {
             return glm::length(sheared(ray_from(x), {0.0f, 0.0f, 1.0f}));
         },
         [=](const Inputs& x) {
             const Wide p(x[0], x[1], -5.0L), d = Wide(0.25L, 0.25L, 10.0L) - p, q = Wide(0, 0, 1.0L) - p;
             const auto [i, j, k] = ray_from(x).axis;
             return std::hypot(q[i] - d[i] / d[k] * q[k], q[j] - d[j] / d[k] * q[k]);
         }},
        {"hit_parameter",
         "points in [-1000, 1000], where the ray is not along the plane",
         "any",
         -1e15,
         1e15,
         true,
         1e-9,
         {{-10.0f, 10.0f, Spread::even, {}}, {-8.0f, 8.0f, Spread::even, {}}},
         [=](const Inputs& x) { return hit_parameter(ray_from(x), triangle); },
         exact_hit},
        {"planar_projection",
         "a light 10 high, points in [-1000, 1000] and 1 high: x on the floor",
         "[-1200, 1200]",
         -1200,
         1200,
         false,
         1e-12,
         {place},
         [](const Inputs& x) {
             const glm::dvec4 image = planar_projection({0, 1, 0, 0}, {0, 10, 0, 1}) * glm::dvec4(x[0], 1, 0, 1);
             return image.x / image.w;
         },
         [](const Inputs& x) { return Real{x[0]} * 10 / 9; }},
        {"volume_factor",
         "whole numbers in [-1000, 1000]",
         "0 or 1",
         0,
         1,
         false,
         0,
         {place},
         [](const Inputs& x) { return volume_factor(static_cast<std::int32_t>(x[0])); },
         [](const Inputs& x) { return static_cast<int>(x[0]) > 0 ? Real{0} : Real{1}; }},
    };
}

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

}  // namespace

std::vector<Formula> formulas_of_shadows() {
    return joined(formulas_of_slopes(), joined(formulas_of_maps(), formulas_of_rays()));
}

}  // namespace kreda::tests
