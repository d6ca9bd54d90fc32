// Which faces bound the shadow of a mesh: caps where the light arrives, sides along the silhouette.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

#include "shadows/shadow.hpp"

namespace kreda::shadows {

/// A triangle of the occluder where the shadow begins.
struct Cap {
    std::array<std::uint32_t, 3> vertex{};  ///< of the occluder, in the order of its indices
    bool is_clockwise = false;              ///< seen from the light
};

/// An edge of the outline, as it runs around the caps beside it: counter-clockwise seen from the light.
struct SilhouetteEdge {
    std::uint32_t from = 0, to = 0;  ///< vertices of the occluder
    int weight = 1;                  ///< how many volumes end here
};

/// The faces of an occluder's shadow volume; the back of the volume is its caps again, pushed away from the light.
struct VolumeShape {
    std::vector<Cap> caps;              ///< its front: triangles that face the light
    std::vector<SilhouetteEdge> sides;  ///< edges from which the sides hang
    std::uint32_t open_triangles = 0;   ///< in pieces of the mesh that are not closed: each casts a volume of its own
};

/// The volume of an occluder, piece by piece (a piece hangs together by shared edges).
///
/// A piece that is closed, with its light outside: the triangles that face the light are the caps, and the sides stand
/// on the edges between a triangle that faces the light and one that does not. Every shadow is counted once per
/// crossing of the surface.
///
/// Any other piece: every triangle is a cap, turned to face the light, and its three edges carry sides; where two caps
/// run along an edge in opposite directions, their sides are the same quad seen from both sides and cancel. This is
/// right for every mesh, whatever its holes (Bergeron 1986, Aldridge & Woods 2004), but has more faces.
///
/// light: homogeneous, see light_ray.hpp. Triangles that are not finite or seen edge on by the light cast nothing.
[[nodiscard]] VolumeShape make_shadow_volume(const Occluder& occluder, const glm::dvec4& light);

}  // namespace kreda::shadows
