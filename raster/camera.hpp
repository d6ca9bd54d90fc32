// The camera: world -> view -> clip -> window, as matrices that read by cancelling neighbours.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace kreda::raster {

/// How depth becomes size.
enum class Projection { perspective, orthographic };

/// Right-handed, looks down -z of its own view space, +y up. Clip space is OpenGL's: -w <= x, y, z <= w.
struct Camera {
    glm::vec3 position{0.0f, 1.0f, 4.0f};             ///< world space
    glm::vec3 target{0.0f};                           ///< world space, not equal to position
    glm::vec3 up{0.0f, 1.0f, 0.0f};                   ///< world space, not parallel to target - position
    Projection projection = Projection::perspective;  ///< perspective or orthographic
    float vertical_fov_deg = 45.0f;                   ///< perspective: full angle from bottom to top, in (0, 180)
    float height = 2.0f;                              ///< orthographic: world units from bottom to top
    float near = 0.1f;                                ///< distance of the near plane, > 0
    float far = 100.0f;                               ///< distance of the far plane, > near
};

/// Width over height of an image.
inline float aspect_of(int width, int height) {
    return static_cast<float>(width) / static_cast<float>(height);
}

/// The directions of whoever looks along `forward` (unit) with `up_hint` upwards, world space. All unit, at right
/// angles.
struct ViewAxes {
    glm::dvec3 right, up, forward;  ///< forward into the scene
};
/// Right, up and backward, unit and at right angles; world space.
[[nodiscard]] ViewAxes view_axes(const glm::dvec3& forward, const glm::dvec3& up_hint);
/// Those of a camera.
[[nodiscard]] ViewAxes view_axes(const Camera& camera);

/// view_from_world: a rotation and a translation (gluLookAt).
[[nodiscard]] glm::mat4 view_from_world(const Camera& camera);

/// clip_from_view for an image of the given aspect = width / height (gluPerspective, glOrtho).
[[nodiscard]] glm::mat4 clip_from_view(const Camera& camera, float aspect);

/// The product of the two: clip_from_view * view_from_world.
[[nodiscard]] glm::mat4 clip_from_world(const Camera& camera, float aspect);

/// Unit vector from the camera into the scene, world space.
[[nodiscard]] glm::vec3 view_direction(const Camera& camera);

}  // namespace kreda::raster
