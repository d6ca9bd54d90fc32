// The environment's light at a batch of points as the integral itself: by many directions, chosen in three ways.
#pragma once

#include "lighting/batch/environment_passes.hpp"
#include "lighting/cook_torrance.hpp"

namespace kreda::lighting {

/// The reference for the split sum: channels.environment.diffuse and .specular of the microfacet model, and .error.
/// Directions are chosen by the facets that v sees (GGX) for the highlight, by their cosine for the rest, and by the
/// environment's own light for both, setup.reference_samples each, weighed by the balance heuristic (Veach & Guibas
/// 1995). Requires maps->light.
void sum_environment(int count, const CookTorranceSetup& surface, const EnvironmentSetup& setup,
                     LightingChannels& channels);

/// The same for the irradiance on n: channels.environment.irradiance, and .error.
void sum_irradiance(int count, const EnvironmentSetup& setup, LightingChannels& channels);

/// channels.irradiance = 0 at so many points: where there is none, and where a sum begins.
void start_irradiance(int lanes, EnvironmentChannels& channels);

}  // namespace kreda::lighting
