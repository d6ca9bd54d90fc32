// What the exact shadow methods share, shadows/light_ray.hpp, planar.hpp and volume.hpp, in long double.
#include <algorithm>
#include <cmath>

#include "shadows/light_ray.hpp"
#include "shadows/planar.hpp"
#include "shadows/volume.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

namespace {

using namespace kreda::shadows;

/// What the exact methods share, in double.
std::vector<Formula> numbers_of_rays() {
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

/// Decisions, 0 or 1, of random rays: where they are as near as an error, no input lies.
std::vector<Formula> formulas_of_decisions() {
    const Axis place{-2.0f, 2.0f, Spread::even, {}};
    const Triangle triangle{{-1.0f, -0.75f, 0.0f}, {1.25f, -0.5f, 0.25f}, {0.25f, 1.5f, -0.25f}};
    const glm::dvec4 light(0.125, 0.25, 8.0, 1.0);
    const auto point = [](const Inputs& x) { return glm::vec3(x[0], x[1], -4.0f); };
    const auto exact_cut = [=](const Inputs& x) {
        const Wide p(point(x)), d = Wide(light) - p;
        const auto side = [&](const glm::vec3& a, const glm::vec3& b) {
            return glm::dot(glm::cross(Wide(a) - p, Wide(b) - p), d) > 0;
        };
        const bool ab = side(triangle.a, triangle.b), bc = side(triangle.b, triangle.c),
                   ca = side(triangle.c, triangle.a);
        return ab == bc && bc == ca ? Real{1} : Real{0};
    };
    return {
        {"cuts",
         "random rays through and beside a triangle",
         "0 or 1",
         0,
         1,
         false,
         0,
         {place, place},
         [=](const Inputs& x) { return cuts(light_ray(light, point(x)), triangle) ? 1.0 : 0.0; },
         exact_cut},
        {"cuts",
         "the same rays, the triangle turned round",
         "0 or 1",
         0,
         1,
         false,
         0,
         {place, place},
         [=](const Inputs& x) {
             return cuts(light_ray(light, point(x)), {triangle.a, triangle.c, triangle.b}) ? 1.0 : 0.0;
         },
         exact_cut},
        {"separates",
         "points on both sides of a triangle's plane",
         "0 or 1",
         0,
         1,
         false,
         0,
         {place, place, {-4.0f, 4.0f, Spread::even, {}}},
         [=](const Inputs& x) {
             return separates(triangle, light, {x[0], x[1], x[2]}) ? 1.0 : 0.0;
         },
         [=](const Inputs& x) {
             const Wide a(triangle.a), normal = glm::cross(Wide(triangle.b) - a, Wide(triangle.c) - a);
             return glm::dot(normal, Wide(x[0], x[1], x[2]) - a) < 0 ? Real{1} : Real{0};
         }},
        {"sheared",
         "points in [-2, 2]: along the first axis",
         "[-8, 8]",
         -8,
         8,
         false,
         1e-14,
         {place, place},
         [=](const Inputs& x) { return sheared(light_ray(light, point(x)), triangle.b).x; },
         [=](const Inputs& x) {
             const Wide p(point(x)), d = Wide(light) - p, q = Wide(triangle.b) - p;
             const auto [i, j, k] = light_ray(light, point(x)).axis;
             return q[i] - d[i] / d[k] * q[k];
         }},
        {"light_ray",
         "points in [-2, 2]: where the light is along the longest axis",
         "[12, 12]",
         12,
         12,
         false,
         0,
         {place, place},
         [=](const Inputs& x) { return light_ray(light, point(x)).direction[light_ray(light, point(x)).axis[2]]; },
         [](const Inputs&) { return Real{12}; }},
    };
}

}  // namespace

std::vector<Formula> formulas_of_rays() {
    return joined(numbers_of_rays(), formulas_of_decisions());
}

}  // namespace kreda::tests
