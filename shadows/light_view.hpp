// The light's own cameras: a directional light looks along parallel rays, a spot from its position, a point light in
// six directions.
#pragma once

#include <array>
#include <span>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "shadows/shadow.hpp"

namespace kreda::shadows {

/// One picture that a light sees. In view space x is right, y up and the light looks down -z, as a camera does; the
/// *distance* of a point is -z: along the axis, not along the ray.
struct LightView {
    glm::mat3 view_from_world{1.0f};  ///< a rotation
    glm::vec3 origin{0.0f};           ///< world space: the light; directional: a point of its plane of distance 0
    bool perspective = false;         ///< point and spot lights; false: directional
    glm::vec2 half_size{1.0f};        ///< half the picture's width and height: world units, or tangents (perspective)
    float near = 0.0f;                ///< distance at which casting begins; perspective: > 0
    float far = 1.0f;                 ///< distance at which it ends
};

/// clip_from_world for the rasterizer.
[[nodiscard]] glm::mat4 clip_from_world(const LightView& view);

/// Axes of a light that shines along `direction` (unit): rows right, up, backward. Up is +y as far as it can be.
[[nodiscard]] glm::mat3 light_axes(const glm::vec3& direction);

/// A box in a light's axes: x right, y up, z the distance along its direction.
struct LightBounds {
    glm::vec3 least{0.0f}, greatest{0.0f};  ///< opposite corners
    bool empty = true;                      ///< nothing was put in: the corners say nothing
};

/// The box around points (world space) in the axes of a light.
[[nodiscard]] LightBounds bounds_along(const glm::mat3& axes, std::span<const glm::vec3> points);
/// The box around both.
[[nodiscard]] LightBounds join(const LightBounds& a, const LightBounds& b);

/// Can what lies in `casters` throw its shadow, along the rays, onto what lies in `seen`?
[[nodiscard]] bool can_cast_onto(const LightBounds& casters, const LightBounds& seen);

/// The picture of a directional light, no larger than it must be: what casts and what is seen, where they lie behind
/// one another along the rays. `size` texels a side, of which `margin` stay free on each side for filters.
[[nodiscard]] LightView directional_view(const glm::vec3& direction, const LightBounds& casters,
                                         const LightBounds& seen, int size, int margin);

/// The picture of a spot whose cone fits into one picture: outer half-angle up to kWidestSpotDeg.
[[nodiscard]] LightView spot_view(const ShadowLight& light, float near, float far, int size, int margin);

/// Beyond this half-angle one flat picture wastes its texels on the border: the light is drawn as six pictures.
inline constexpr float kWidestSpotDeg = 60.0f;

/// The six pictures of a point light: +x -x +y -y +z -z. Each reaches `margin` texels beyond its quarter turn, so that
/// a filter finds what it needs on its own face.
[[nodiscard]] std::array<LightView, 6> cube_views(const glm::vec3& position, float near, float far, int size,
                                                  int margin);

}  // namespace kreda::shadows
