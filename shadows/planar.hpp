// Planar shadows: flatten every occluder onto the plane that receives the shadow and mark the samples it covers there.
// Blinn 1988, "Me and My (Fake) Shadow"
#pragma once

#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "raster/convex_polygon.hpp"
#include "shadows/shadow.hpp"

namespace kreda::shadows {

/// A plane is the vector P = (n, d), n unit: P . (q, 1) is the height of q over it.

/// From the light L through q onto the plane P:   M = (P . L) I - L P^T      Blinn 1988, equation for any light and
/// plane P . (M q) = 0: the image lies in the plane. Its w is P . L - L_w (P . q): 0 for what is as high as a point
/// light, and below 0 for what is higher, whose image would lie on the wrong side of the light ("anti-shadow"). So clip
/// first.
inline glm::dmat4 planar_projection(const glm::dvec4& plane, const glm::dvec4& light) {
    return glm::dot(plane, light) * glm::dmat4(1.0) - glm::outerProduct(light, plane);
}

/// The plane of an occluder, its front on the side from which triangles are counter-clockwise; nothing if it is not
/// flat, as far as float positions can tell.
[[nodiscard]] std::optional<glm::dvec4> plane_of(const Occluder& occluder);

/// A convex part of a triangle, its corners homogeneous.
using OccluderPart = raster::ConvexPolygon<glm::dvec4, 8>;

/// The part of a triangle that can shadow the plane: above it and below the light; possibly empty.
[[nodiscard]] OccluderPart between_plane_and_light(const glm::dvec4& plane, const glm::dvec4& light, const glm::vec3& a,
                                                   const glm::vec3& b, const glm::vec3& c);

/// How one light throws images onto one plane of one picture.
struct PlanarSetup {
    glm::dvec4 light{0.0};               ///< homogeneous
    glm::dvec4 toward{0.0};              ///< the plane, its front to the light
    glm::dmat4 clip_from_occluder{1.0};  ///< world to clip space by way of the plane
    bool casts = false;                  ///< the light does not shine along the plane
};
/// What does not change from triangle to triangle.
[[nodiscard]] PlanarSetup planar_setup(const glm::dvec4& plane, const ShadowLight& light,
                                       const VisibleSamples& samples);

/// For explanations: the first triangle whose image covers sample (x, y), as the picture's triangles are asked.
struct PlanarCause {
    std::size_t occluder = 0;  ///< index into the occluders
    std::size_t triangle = 0;  ///< of the occluder's indices, three each
};
/// Which triangle puts the sample (x, y) into shadow, if one does.
[[nodiscard]] std::optional<PlanarCause> planar_cause(std::span<const Occluder> occluders, const glm::dvec4& plane,
                                                      const ShadowLight& light, const VisibleSamples& samples, int x,
                                                      int y);

/// One factor a sample, as if every sample lay on the plane: 1 lit, 0 in shadow. A mask: a sample that many triangles
/// cover is no darker than one that a single triangle covers. Only samples that see the plane's object are to be read.
void planar_shadow(std::span<const Occluder> occluders, const glm::dvec4& plane, const ShadowLight& light,
                   const VisibleSamples& samples, std::span<float> shadow);

}  // namespace kreda::shadows
