// Two-sided lighting: which triangles show the side that their normals point away from.
#pragma once

#include <glm/vec3.hpp>

#include "raster/triangle_setup.hpp"

namespace kreda::scene {

/// Are a triangle's normals to be turned to the viewer?
/// behind: the viewer sees its back, by its winding; front_normal: perpendicular to it, on its front, any length;
/// normal: the sum of its corners' normals; to_viewer: any length.
/// The winding decides where the normals stand on its front. A triangle whose normals contradict its winding (a mesh
/// wound inwards that has the right normals, a sliver that is folded over) is seen from behind where its normal clearly
/// points away from the viewer, and where that is not clear, if the normal is not on the viewer's side of it.
[[nodiscard]] bool seen_from_behind(bool behind, const glm::vec3& front_normal, const glm::vec3& normal,
                                    const glm::vec3& to_viewer);

/// From where a picture is seen.
struct Viewer {
    glm::vec3 eye{0.0f};      ///< world space
    glm::vec3 forward{0.0f};  ///< unit, into the scene
    bool orthographic = false;
};

/// That question for a triangle that reached the tiles, whose `behind` is what its winding says. The streams hold
/// positions and normals.
[[nodiscard]] bool judge_side(const raster::VertexStreams& streams, const Viewer& viewer,
                              const raster::ScreenTriangle& triangle);

}  // namespace kreda::scene
