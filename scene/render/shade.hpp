// Light a batch of points: the passes of lighting/ and shadows/ in the order of the lecture.
#pragma once

#include <cstdint>

#include "lighting/batch/channels.hpp"
#include "raster/fragments.hpp"
#include "scene/render/frame.hpp"
#include "scene/render/tile_pass.hpp"

namespace kreda::scene {

/// radiance = ambient + sum over lights of shadow (diffuse + specular)  at every point, without fog: the frame's
/// lighting passes that work on this material, one after another.
/// Points are samples of the picture (phong), vertices (gouraud) or centroids of triangles (flat): it is all the same
/// here. They share a material; positions and normals are in world space. What the passes take is told to
/// scratch.clock.
void shade_points(const Frame& frame, const raster::Fragments& points, std::uint32_t material,
                  lighting::LightingChannels& channels, TileScratch& scratch);

}  // namespace kreda::scene
