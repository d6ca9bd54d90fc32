// Lighting before rasterization: at the vertices (Gouraud) or once a triangle (flat), and fog at the vertices. The
// passes light_vertices, light_triangles and fog_vertices are listed in scene/plan/pass_functions.hpp.
#pragma once

#include "raster/triangle_setup.hpp"
#include "scene/render/frame.hpp"

namespace kreda::scene {

/// Vertices of the streams, from `first` on, as points 0 .. count-1 of a batch that is lit. Maps are read there, at
/// level 0: a vertex has no neighbour that would say how far the texture is stretched.
/// behind: the other side of the surface, with normal and tangent frame turned.
void set_vertex_points(const Frame& frame, std::uint32_t first, int count, bool behind, raster::Fragments& points);

/// Centroid and normal of a triangle of the scene in world space, before any clipping, as point i of a batch.
/// Maps are read at the centroid's uv; the steps of uv are half of two edges, so that the level is that of a sample as
/// wide as half the triangle.
/// orientation: orientation_of(); behind: the other side of the triangle.
void set_flat_point(const RenderBuffers& buffers, const raster::TriangleChunk& chunk,
                    const raster::ScreenTriangle& triangle, float orientation, bool behind, int i,
                    raster::Fragments& points);

/// -1 for a transform that mirrors: it turns counter-clockwise into clockwise, and the face's normal is then the other
/// cross product. Else 1.
[[nodiscard]] float orientation_of(const glm::mat4& world_from_object);

}  // namespace kreda::scene
