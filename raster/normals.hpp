// Vertex normals for meshes that come without them, or that should look rounder or sharper than they came.
//
// All three functions replace mesh.normals, keep the order of the triangles and the parts, and may append copies of
// vertices (position and uv follow). A vertex whose normal cannot be found, because all its triangles are degenerate or
// it has none, gets +y; the return value counts these. The same mesh gives the same result to the last bit.
#pragma once

#include <cstdint>
#include <span>

#include "raster/mesh.hpp"

namespace kreda::raster {

/// Smooth normals: n = normalize(sum of (q - p) x (r - p) over the triangles pqr at the point), which weighs each
/// triangle by its area (Gouraud 1971 with the weight of the cross product).
/// Two triangles are summed together if they share an edge with an angle between their normals of at most
/// crease_angle_deg, or are linked at that point by such edges; elsewhere the vertex is split. 0 splits all but flat
/// edges, 180 and more smooths over every edge. Vertices at bitwise equal positions are one point for this.
std::uint32_t make_smooth_normals(Mesh& mesh, float crease_angle_deg = 60.0f);

/// The same for meshes that come without normals: where the crease cuts one to three triangles out of a surface that
/// goes on around them, they are noise of a scanner and are summed with it. A flat face keeps its edges: a smooth wall
/// turns by at most the crease at each of its corners, so at 60 degrees it has 6 corners and at least 4 triangles.
std::uint32_t make_smooth_normals_without_specks(Mesh& mesh);

/// The same sum over the triangles of equal smoothing group (the `s` lines of an OBJ): one entry a triangle, 0 is flat.
std::uint32_t make_smooth_normals_by_group(Mesh& mesh, std::span<const std::uint32_t> smoothing_group_of_triangle);

/// Flat normals: every triangle gets its own three vertices with the normal of its plane. Unused vertices go away.
std::uint32_t make_flat_normals(Mesh& mesh);

}  // namespace kreda::raster
