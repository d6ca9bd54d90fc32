// Light from the environment at a batch of points: the split sum, or the integral itself by many samples.
#pragma once

#include <glm/vec3.hpp>

#include "lighting/batch/channels.hpp"
#include "lighting/batch/passes.hpp"
#include "lighting/environment/environment.hpp"
#include "raster/fragments.hpp"

namespace kreda::lighting {

struct MaterialSetup;

/// What the environment adds to channels.ambient, after start_lighting and before the lights.
///   cook_torrance   ao (k_d c E / pi + P (F0 A + B)),   k_d = (1 - F(n.v))(1 - metallic)           Karis 2013;
///   Gelemanovic 2018, 3 Lambert and the other empirical models   m_D E / pi: diffuse light only, their highlights are
///   made for lamps
/// E is the irradiance on n, P the prefiltered radiance from r = 2 (n.v) n - v. With reference_samples the two
/// integrals themselves, by directions chosen in three ways, N each: facets that v sees (GGX) for the highlight, the
/// cosine for the rest, and the environment's own light for both, weighed by the balance heuristic (Veach & Guibas
/// 1995). channels.environment.error is what their scatter says about the sum: Hammersley's points are more even than
/// random ones, so that the true error is mostly less. Requires maps->light.
/// Unless channels are always to be left, what it adds may go to ambient without standing in channels of its own.
void add_environment(const raster::Fragments& fragments, const MaterialSetup& material, const EnvironmentSetup& setup,
                     LeaveChannels leave, LightingChannels& channels);

/// Radiance from these directions (world space, any length) into channels.prefiltered. Returns them as the maps know
/// them: themselves, or channels.map_direction.
const raster::Channel3& look_at_environment(int count, const EnvironmentSetup& setup, const raster::Channel3& direction,
                                            EnvironmentChannels& channels);

}  // namespace kreda::lighting
