// Cook and Torrance's model for a batch: angles, D, V, F, sum; each a loop over the one formula that
// lighting/microfacet_choices.hpp picks.
#pragma once

#include "lighting/batch/channels.hpp"
#include "lighting/cook_torrance.hpp"
#include "lighting/microfacet_choices.hpp"

namespace kreda::lighting {

/// Give every point the constants that stood in one place, so that each may be written over.
void fill_surface(int count, SurfaceChannels& surface);

/// n.v, the same for all lights, from channels.n and channels.v.
void set_viewing_angle(int count, LightingChannels& channels);

/// The other angles, D, V and F of the light in channels.l, channels.n_dot_l.
void evaluate_microfacets(int count, const CookTorranceSetup& setup, LitBy lit_by, LightingChannels& channels);

/// F of the material's method at the cosines in channels.v_dot_h.
void evaluate_fresnel(int count, const CookTorranceSetup& setup, MicrofacetChannels& channels);

/// What a light from a direction chosen by visible_half_vector counts for, without F   D V (n.l) / p. Reads the
/// surface's channels: call fill_surface before.
///   p = D_GGX G_1(v) / (4 n.v),   G_1(v) = 2 (n.v) / (n.v + root):   2 V (n.l) (n.v + root) D / D_GGX
inline float visible_weight(const MicrofacetChannels& m, int i) {
    const float alpha = m.surface.alpha.at(i);
    const float n_dot_v = m.n_dot_v.at(i);
    const float D_ggx = ggx_distribution(m.n_dot_h.at(i), m.sin2_h.at(i), alpha);
    const float ratio = m.D.at(i) / (D_ggx > 1e-18f ? D_ggx : 1e-18f);
    return 2.0f * m.V.at(i) * m.n_dot_l.at(i) * (n_dot_v + smith_root(n_dot_v, alpha)) * ratio;
}

/// Add what the light in channels.l, channels.n_dot_l, channels.irradiance reflects to channels.diffuse and
/// channels.specular.
void add_cook_torrance(int count, const CookTorranceSetup& setup, LightingChannels& channels);

}  // namespace kreda::lighting
