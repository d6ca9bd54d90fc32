// Does a triangle stand between a point and the light? The geometry that every exact method shares, in double.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "shadows/shadow.hpp"

namespace kreda::shadows {

/// A triangle that casts a shadow, world space.
struct Triangle {
    glm::vec3 a{0.0f}, b{0.0f}, c{0.0f};  ///< corners
};

/// Where the light is as one homogeneous point L: (position, 1) for point and spot, (-direction, 0), infinitely far
/// away, for directional.                                                                                       Blinn
/// 1988
inline glm::dvec4 homogeneous(const ShadowLight& light) {
    if (light.kind == LightKind::directional) return glm::dvec4(-glm::dvec3(light.direction), 0.0);
    return glm::dvec4(glm::dvec3(light.position), 1.0);
}

/// From p to the light, not unit: D = L_xyz - L_w p. For a point light p + D is the light itself; a directional light
/// lies at p + t D for no finite t.
inline glm::dvec3 toward_light(const glm::dvec4& light, const glm::dvec3& p) {
    return glm::dvec3(light) - light.w * p;
}

/// How many roundings of a float (2^-24 of the largest coordinate) a point that was interpolated within a triangle may
/// lie beside the triangle's plane: the weights, their sum, three products, two sums, and as much again where the
/// clipper made the corners. Measured in tests/shadows/test_light_ray.cpp: at most 3.
inline constexpr double kInterpolationRoundings = 16.0;

/// The largest absolute value of the three.
inline double largest_coordinate(const glm::vec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Does the triangle's plane separate p from the light?  Not if it holds one of them: p as far as float positions can
/// tell.
///
/// This is the rule against self-shadowing: a triangle whose plane holds the point does not shadow it. The triangle
/// that p lies on never does, nor do the neighbours that continue it in the same plane, nor those around a vertex that
/// is lit. There is no length to choose: the bound is the rounding error of p itself. What it costs: an occluder
/// parallel to the receiver and nearer than 1e-6 of its coordinates casts no shadow.
inline bool separates(const Triangle& t, const glm::dvec4& light, const glm::vec3& p) {
    const glm::dvec3 a(t.a);
    const glm::dvec3 normal = glm::cross(glm::dvec3(t.b) - a, glm::dvec3(t.c) - a);
    const double height = glm::dot(normal, glm::dvec3(p) - a);
    const double light_height = glm::dot(normal, toward_light(light, a));
    const double size =
        std::max({largest_coordinate(t.a), largest_coordinate(t.b), largest_coordinate(t.c), largest_coordinate(p)});
    const double tolerance = kInterpolationRoundings * 0x1p-24 * size;
    const bool above_rounding = height * height > tolerance * tolerance * glm::dot(normal, normal);
    return above_rounding & (height > 0.0 ? light_height < 0.0 : light_height > 0.0);
}

/// The line from a point to the light, made ready: the axes are renamed so that D is longest along z, and sheared so
/// that D points along z exactly.                                                            Woop, Benthin & Wald 2013
struct LightRay {
    glm::dvec3 origin{0.0};               ///< the point, world space
    glm::dvec3 direction{0.0, 0.0, 1.0};  ///< D, not unit
    double end = 1.0;                     ///< where the light is, in lengths of D; infinite for a directional light
    std::array<int, 3> axis{0, 1, 2};     ///< x, y, z of the sheared space are these axes of the world
    double shear_x = 0.0, shear_y = 0.0;  ///< how far x and y move for each step along z
};

/// The ray from the point p to the light.
inline LightRay light_ray(const glm::dvec4& light, const glm::vec3& p) {
    LightRay ray;
    ray.origin = p;
    ray.direction = toward_light(light, ray.origin);
    ray.end = light.w == 0.0 ? HUGE_VAL : 1.0;
    const glm::dvec3 length = glm::abs(ray.direction);
    const int z = length.x > length.y ? (length.x > length.z ? 0 : 2) : (length.y > length.z ? 1 : 2);
    ray.axis = {(z + 1) % 3, (z + 2) % 3, z};
    ray.shear_x = ray.direction[ray.axis[0]] / ray.direction[z];
    ray.shear_y = ray.direction[ray.axis[1]] / ray.direction[z];
    return ray;
}

/// Where a corner lies beside the line, which runs through (0, 0).
inline glm::dvec2 sheared(const LightRay& ray, const glm::vec3& corner) {
    const glm::dvec3 q = glm::dvec3(corner) - ray.origin;
    const double z = q[ray.axis[2]];
    return {q[ray.axis[0]] - ray.shear_x * z, q[ray.axis[1]] - ray.shear_y * z};
}

/// Does the line pass through the triangle?                                           Woop, Benthin & Wald 2013
///
/// U, V, W are twice the signed areas that the line's foot spans with each edge. Watertight: the two triangles of an
/// edge compute the same products with the signs exchanged, so a line never slips through between them. A foot exactly
/// on an edge belongs to both. (The paper computes in float and once more in double where an area is 0; float corners
/// in double need no second try.)
inline bool cuts(const LightRay& ray, const Triangle& t) {
    const glm::dvec2 a = sheared(ray, t.a);
    const glm::dvec2 b = sheared(ray, t.b);
    const glm::dvec2 c = sheared(ray, t.c);
    const double U = c.x * b.y - c.y * b.x;
    const double V = a.x * c.y - a.y * c.x;
    const double W = b.x * a.y - b.y * a.x;
    const bool any_negative = (U < 0.0) | (V < 0.0) | (W < 0.0);
    const bool any_positive = (U > 0.0) | (V > 0.0) | (W > 0.0);
    return any_negative != any_positive;  // neither: no area, or seen edge on
}

/// Where the line meets the triangle's plane, in lengths of D from its start:  t = n.(a - o) / n.D
inline double hit_parameter(const LightRay& ray, const Triangle& t) {
    const glm::dvec3 a(t.a);
    const glm::dvec3 normal = glm::cross(glm::dvec3(t.b) - a, glm::dvec3(t.c) - a);
    return glm::dot(normal, a - ray.origin) / glm::dot(normal, ray.direction);
}

/// Does the triangle stand between the point that the ray starts from and the light?
inline bool shadows_point(const LightRay& ray, const Triangle& t, const glm::dvec4& light, const glm::vec3& p) {
    return cuts(ray, t) && separates(t, light, p);
}

}  // namespace kreda::shadows
