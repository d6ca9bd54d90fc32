// Where a point of a surface lies in a light's picture, and how much nearer to the light it must be taken to be: the
// bias.
#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "raster/cube_face.hpp"
#include "raster/unit_vector.hpp"
#include "shadows/light_view.hpp"

namespace kreda::shadows {

/// How far a flat surface falls away from the light from one texel to the next: to the right, and down.  [world units]
struct DepthSlope {
    float u = 0.0f, v = 0.0f;  ///< to the right, and down
};

/// The least bias that keeps a flat surface from shadowing itself when the nearest texel is read. Its depth is right at
/// the texel's centre, at most half a texel away in u and in v:
///     B = (|z_u| + |z_v|) / 2
/// A filter of (2m + 1)^2 texels that compares all of them with one depth needs (2m + 1) B.
/// Holds to the last digit, up to the rasterizer's snap to 1/256 texel (tested).   Dou, Yan, Kerzner, Dai, Wyman 2014
inline float least_bias(const DepthSlope& slope) {
    const float u = slope.u < 0.0f ? -slope.u : slope.u;
    const float v = slope.v < 0.0f ? -slope.v : slope.v;
    return 0.5f * (u + v);
}

/// The least shift along the normal that does the same: the surface moved by delta is nearer to the light by
/// delta / cos(theta), and B = texel (|n_x| + |n_y|) / (2 cos(theta)), so
///     delta = texel (|n_x| + |n_y|) / 2  <=  (texel / sqrt(2)) sin(theta)
/// with n in the light's axes. It stays bounded where the light grazes the surface.                  Holbert 2011
inline float least_normal_offset(const glm::vec3& n_view, const glm::vec2& texel) {
    const float x = n_view.x < 0.0f ? -n_view.x : n_view.x;
    const float y = n_view.y < 0.0f ? -n_view.y : n_view.y;
    return 0.5f * (texel.x * x + texel.y * y);
}

/// Squared length below which a normal counts as none: that of a triangle without area. It is far below
/// raster::kLeastLength2, for the normal of a tiny triangle is as short as the triangle is small.
inline constexpr float kLeastNormal2 = 1e-36f;

/// Beyond this angle a surface is taken to be no steeper: the slope is the tangent, and it has no bound.
inline constexpr float kLeastCosine = 0.01f;

/// cos(theta) with its sign, kept away from zero.
inline float steepness_limit(float cosine) {
    const float positive = cosine > kLeastCosine ? cosine : kLeastCosine;
    const float negative = cosine < -kLeastCosine ? cosine : -kLeastCosine;
    return cosine < 0.0f ? negative : positive;
}

/// A directional light: the plane n . q = c has distance (n_x x + n_y y - c) / n_z.   texel: its width and height
inline DepthSlope slope_parallel(const glm::vec3& n_view, const glm::vec2& texel) {
    const float inverse = 1.0f / steepness_limit(n_view.z);
    return {n_view.x * inverse * texel.x, -n_view.y * inverse * texel.y};
}

/// A light with a position: on the plane 1/distance = (n_x X + n_y Y - n_z) / c is affine in the tangents X =
/// x/distance and Y = y/distance; its derivative gives the distance's.   q: the point in view space; texel: in tangents
inline DepthSlope slope_perspective(const glm::vec3& n_view, const glm::vec3& q, float distance,
                                    const glm::vec2& texel) {
    const float cosine = -glm::dot(n_view, q) / distance;  // of the angle with the ray, times its length for distance 1
    const float factor = distance / steepness_limit(cosine);
    return {n_view.x * factor * texel.x, -n_view.y * factor * texel.y};
}

/// What the bias is made of, in world units along the light's axis.
struct BiasTerms {
    float constant = 0.0f;       ///< taken off the distance
    float slope = 0.0f;          ///< times least_bias()
    float normal_offset = 0.0f;  ///< times least_normal_offset()
    float follow_plane = 0.0f;   ///< 1: taps beside the centre are compared with the surface's plane, 0: with one depth
};

/// The terms for a map whose depth 0..1 spans near..far.
[[nodiscard]] inline BiasTerms bias_terms(const ShadowSettings& settings, float depth_range) {
    const float constant = settings.constant_bias * depth_range;
    switch (settings.bias) {
        case ShadowBias::none: return {};
        case ShadowBias::constant: return {constant, 0.0f, 0.0f, 0.0f};
        case ShadowBias::slope: return {constant, settings.slope_bias, 0.0f, 1.0f};
        case ShadowBias::normal_offset: return {constant, 0.0f, settings.slope_bias, 1.0f};
    }
    return {};
}

/// A surface point in a light's picture.
struct MapPoint {
    float u = 0.0f, v = 0.0f;  ///< texels from the upper left corner: column and row of its texel are the whole parts
    float distance = 0.0f;     ///< from the light along its axis, less the bias, world units
    DepthSlope slope;          ///< of the surface there; 0 where the bias does not follow it
};

/// One picture, as the loop over a batch needs it.
struct PictureScale {
    glm::vec2 texel{1.0f};            ///< its width and height: world units, or tangents
    glm::vec2 texels_per_unit{1.0f};  ///< 1 / texel
    float half_side = 0.5f;           ///< half the number of texels a side
};

/// From the light's view to texels of a map with `size` a side.
[[nodiscard]] inline PictureScale picture_scale(const LightView& view, int size) {
    const float side = static_cast<float>(size);
    return {2.0f * view.half_size / side, side / (2.0f * view.half_size), 0.5f * side};
}

/// How far a point is moved along its normal, times least_normal_offset(). A surface that turns its back to the light
/// is dark because its own other side is nearer; close to the outline that side may miss the texel's centre, so the
/// point is looked up a little inside.
inline float offset_factor(const BiasTerms& bias, float cosine) {
    return cosine < 0.0f ? -(bias.normal_offset + bias.slope) : bias.normal_offset;
}

/// How much of least_bias() is taken off the distance: nothing on the side that is dark anyway.
inline float slope_factor(const BiasTerms& bias, float cosine) {
    return cosine < 0.0f ? 0.0f : bias.slope;
}

/// The way from a point to its MapPoint, step by step; the loop over a batch keeps the last one only.
struct MapSteps {
    float cosine = 0.0f;       ///< > 0: the surface faces the light; directional light: of the angle between them
    float offset = 0.0f;       ///< along the normal, world units
    glm::vec3 moved{0.0f};     ///< the point after that, in the light's axes
    float distance = 0.0f;     ///< of the moved point along the light's axis, before the bias
    DepthSlope slope;          ///< of the surface there
    float slope_share = 0.0f;  ///< how many times least_bias() is taken off
    MapPoint point;            ///< where it falls in the picture
};

/// q: the point, n_view: the unit normal of its surface, both in the axes of a directional light.
inline MapSteps map_steps_parallel(const glm::vec3& q, const glm::vec3& n_view, const PictureScale& scale,
                                   const BiasTerms& bias) {
    MapSteps s;
    s.cosine = n_view.z;
    s.offset = offset_factor(bias, s.cosine) * least_normal_offset(n_view, scale.texel);
    s.moved = q + n_view * s.offset;
    s.distance = -s.moved.z;
    s.slope = slope_parallel(n_view, scale.texel);
    s.slope_share = slope_factor(bias, s.cosine);
    s.point.u = s.moved.x * scale.texels_per_unit.x + scale.half_side;
    s.point.v = scale.half_side - s.moved.y * scale.texels_per_unit.y;
    s.point.distance = s.distance - bias.constant - s.slope_share * least_bias(s.slope);
    s.point.slope = {s.slope.u * bias.follow_plane, s.slope.v * bias.follow_plane};
    return s;
}

/// The same for a light at the origin of the axes. A point at or behind it comes out somewhere, at distance 0 or less:
/// lit.
inline MapSteps map_steps_perspective(const glm::vec3& q, const glm::vec3& n_view, const PictureScale& scale,
                                      const BiasTerms& bias) {
    constexpr float kTiny = 1e-20f;
    const float before = -q.z > kTiny ? -q.z : kTiny;
    MapSteps s;
    s.cosine = -glm::dot(n_view, q);  // its sign
    s.offset = offset_factor(bias, s.cosine) * least_normal_offset(n_view, scale.texel * before);
    s.moved = q + n_view * s.offset;
    s.distance = -s.moved.z > kTiny ? -s.moved.z : kTiny;
    const float inverse = 1.0f / s.distance;
    s.slope = slope_perspective(n_view, s.moved, s.distance, scale.texel);
    s.slope_share = slope_factor(bias, s.cosine);
    s.point.u = s.moved.x * inverse * scale.texels_per_unit.x + scale.half_side;
    s.point.v = scale.half_side - s.moved.y * inverse * scale.texels_per_unit.y;
    s.point.distance = s.distance - bias.constant - s.slope_share * least_bias(s.slope);
    s.point.slope = {s.slope.u * bias.follow_plane, s.slope.v * bias.follow_plane};
    return s;
}

/// Place, distance and slope on the map of a light with parallel rays; q and n_view in the light's view.
inline MapPoint map_point_parallel(const glm::vec3& q, const glm::vec3& n_view, const PictureScale& scale,
                                   const BiasTerms& bias) {
    return map_steps_parallel(q, n_view, scale, bias).point;
}

/// The same for a light with a place; q and n_view in the light's view.
inline MapPoint map_point_perspective(const glm::vec3& q, const glm::vec3& n_view, const PictureScale& scale,
                                      const BiasTerms& bias) {
    return map_steps_perspective(q, n_view, scale, bias).point;
}

/// World axes -> right, up, backward of a face of the cube around the light (cube_views()).
inline glm::vec3 in_face_axes(const raster::CubeFace& f, const glm::vec3& v) {
    const float right = f.on_x() ? v.z : (f.on_y() ? v.x : -v.x);
    const float up = f.on_y() ? v.z : v.y;
    const float forward = f.on_x() ? v.x : (f.on_y() ? v.y : v.z);
    return {f.sign * right, up, -f.sign * forward};
}

/// A point of a surface and its unit normal in the axes of a picture of the light.
struct PointInView {
    glm::vec3 q{0.0f}, n{0.0f};  ///< place and unit normal
    int face = 0;                ///< of a cube
};

/// axes: view_from_world of the one picture of a light; normal: any length.
inline PointInView point_in_picture(const glm::mat3& axes, const glm::vec3& origin, const glm::vec3& position,
                                    const glm::vec3& normal) {
    return {axes * (position - origin), axes * raster::unit(normal, kLeastNormal2), 0};
}

/// In the one of the six pictures that the point lies in.
inline PointInView point_in_cube(const glm::vec3& origin, const glm::vec3& position, const glm::vec3& normal) {
    const glm::vec3 from_light = position - origin;
    const raster::CubeFace face = raster::cube_face(from_light);
    return {in_face_axes(face, from_light), in_face_axes(face, raster::unit(normal, kLeastNormal2)), face.face};
}

}  // namespace kreda::shadows
