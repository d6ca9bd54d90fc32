// Cook and Torrance's model for a batch: angles, D, V, F, sum; each a loop over one formula. 4 distributions, 5 geometries and
// 10 Fresnel methods are some 20 loops, not 200.
#pragma once

#include "lighting/channels.hpp"
#include "lighting/cook_torrance.hpp"

namespace kreda::lighting {

/// The material's constants at every point (read_maps overwrites what maps give).
void fill_surface(int count, const CookTorranceSetup& setup, MicrofacetChannels& channels);

/// Add what the light in channels.l, channels.irradiance reflects to channels.diffuse and channels.specular.
void add_cook_torrance(int count, const CookTorranceSetup& setup, LightingChannels& channels);

}  // namespace kreda::lighting
