// Lighting before rasterization: at the vertices (Gouraud) or once a triangle (flat), and fog at the vertices.
#pragma once

#include "scene/frame.hpp"

namespace kreda::scene {

/// Gouraud: light every vertex, into streams.color.
void light_vertices(const Frame& frame);

/// Fog factor of every vertex, into streams.fog.
void fog_vertices(const Frame& frame);

/// Flat: light every triangle that reached the tiles once, at its centroid with its own normal, into flat_color.
void light_triangles(const Frame& frame);

}  // namespace kreda::scene
