// The shadow of one light at one point as a derivation: what the method looked at, and what decided.
#pragma once

#include <string>

#include "tools/explain/explain_light.hpp"

namespace kreda::tools {

/// Append what the planned shadow's method does at the point; its last equation is "shadow", found by the functions of
/// the render and equal to its channel.
void explain_shadow(const LitPoint& point, const scene::PlannedShadow& planned, Section& section);

/// method = "map": the place in the light's picture, the bias, each tap of the filter, blockers and penumbra.
/// Returns the share of the light.
float explain_shadow_map(const LitPoint& point, const shadows::ShadowMap& map, Section& section);

}  // namespace kreda::tools
