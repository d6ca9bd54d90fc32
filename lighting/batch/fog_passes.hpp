// Fog for a batch of points that are lit: its factor, then the mix.
#pragma once

#include <glm/vec3.hpp>

#include "lighting/batch/channels.hpp"
#include "lighting/batch/setup.hpp"
#include "raster/fragments.hpp"

namespace kreda::lighting {

/// The fog factor of each point from its position.
void fog_factors(const raster::Fragments& fragments, const LightingSetup& setup, LightingChannels& channels);

/// Instead of fog_factors where the factor was computed at the vertices: f = fragments.fog, in [0, 1].
void copy_fog(const raster::Fragments& fragments, LightingChannels& channels);

/// radiance = f radiance + (1 - f) fog colour.
void apply_fog(int count, const glm::vec3& fog_color, LightingChannels& channels);

}  // namespace kreda::lighting
