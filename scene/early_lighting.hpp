// Lighting before rasterization: at the vertices (Gouraud) or once a triangle (flat), and fog at the vertices.
#pragma once

#include "lighting/passes.hpp"
#include "scene/render.hpp"

namespace kreda::scene {

/// Gouraud: light every vertex, into streams.color.
void light_vertices(const RenderPlan& plan, const lighting::LightingSetup& setup, RenderBuffers& buffers);

/// Fog factor of every vertex, into streams.fog.
void fog_vertices(const lighting::LightingSetup& setup, RenderBuffers& buffers);

/// Flat: light every triangle that reached the tiles once, at its centroid with its own normal, into flat_color.
void light_triangles(const RenderPlan& plan, const lighting::LightingSetup& setup, RenderBuffers& buffers);

}  // namespace kreda::scene
