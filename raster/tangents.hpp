// Tangents: which way u grows on a surface. Normal maps and anisotropic highlights are told in this direction.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "raster/mesh.hpp"

namespace kreda::raster {

/// What make_tangents had to decide.
struct TangentReport {
    std::uint32_t split_vertices = 0;        ///< mirrored and unmirrored triangles met there: now two vertices
    std::uint32_t degenerate_triangles = 0;  ///< their three uvs lie on a line: they say nothing about u
    std::uint32_t without_direction = 0;     ///< vertices in use of which no triangle says anything, or all cancel
};

/// Fill mesh.tangents. Requires uvs and normals, one a vertex; nothing may be appended to the mesh afterwards.
///   dP/du = (e1 dv2 - e2 dv1) / (du1 dv2 - du2 dv1)      e, du, dv: along two edges of a triangle   Lengyel 2001
/// A vertex has the sum over its triangles of the direction of dP/du in the plane perpendicular to its normal, each
/// weighted by the triangle's angle there: the rule of MikkTSpace (Mikkelsen 2008), by which normal maps are made.
/// w = -1 where the picture is mirrored on the surface: bitangent = w (n x t). A vertex where both meet is split.
/// Vertices without a direction get any tangent perpendicular to the normal, w = +1.
TangentReport make_tangents(Mesh& mesh);

/// A unit vector perpendicular to n (unit, or 0: then +x): the same for the same n.
[[nodiscard]] glm::dvec3 any_perpendicular(const glm::dvec3& n);

}  // namespace kreda::raster
