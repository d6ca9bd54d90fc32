// Cook and Torrance's model   f = k_d c / pi + D V F          Cook & Torrance 1982; Gelemanovic 2018, section 2
//   D  microfacets facing the half vector     V = G / (4 (n.l)(n.v))  seen by both     F  Fresnel at v.h
//   F0 = mix(0.04, albedo, metallic)     k_d = (1 - F)(1 - metallic)     alpha = roughness^2
//
// cook_torrance() is the whole formula at one point. A large batch runs the same formulas as passes of their own, each
// leaving a channel: angles; D; V; F; combine. lighting/microfacet_choices.hpp picks D, V and F for both.
#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "lighting/cook_torrance_setup.hpp"
#include "lighting/energy.hpp"
#include "lighting/fresnel.hpp"
#include "lighting/material.hpp"
#include "lighting/microfacet.hpp"
#include "lighting/reflection.hpp"
#include "lighting/spectrum.hpp"

namespace kreda::lighting {

/// F0 = mix(0.04, albedo, metallic)                                                    Gelemanovic 2018, section 2.2.3
inline glm::vec3 base_reflectivity(const glm::vec3& albedo, float metallic) {
    return glm::vec3(kDielectricF0 * (1.0f - metallic)) + albedo * metallic;
}

/// The surface where maps give albedo, metallic and roughness.
inline MicrofacetSurface surface_from_maps(const glm::vec3& albedo, float metallic, float roughness,
                                           const CookTorranceSetup& setup) {
    const glm::vec3 f0 = setup.has_index ? setup.surface.f0 : base_reflectivity(albedo, metallic);
    return {albedo, f0, metallic, roughness, alpha_from_roughness(roughness)};
}

/// What goes in and is scattered, per channel   k_d = (1 - F)(1 - metallic)
inline glm::vec3 diffuse_share(const glm::vec3& F, float metallic) {
    const glm::vec3 transmitted{raster::saturate(1.0f - F.x), raster::saturate(1.0f - F.y),
                                raster::saturate(1.0f - F.z)};
    return transmitted * (1.0f - metallic);
}

/// What D, V and F together reflect of one light, times n.l.
///   diffuse  k_d c / pi (n.l),   k_d = (1 - F)(1 - metallic)      specular  D V F (n.l)
inline ReflectedTerms combine_terms(float n_dot_l, float D, float V, const glm::vec3& F, const glm::vec3& albedo,
                                    float metallic) {
    const glm::vec3 k_d = diffuse_share(F, metallic);
    return {k_d * albedo * (raster::kInvPi * n_dot_l), F * (D * V * n_dot_l)};
}

/// D of the chosen distribution.
[[nodiscard]] float distribution_term(Distribution distribution, const MicrofacetAngles& angles, float alpha);

/// V of the chosen geometry.
[[nodiscard]] float visibility_term(Geometry geometry, const MicrofacetAngles& angles, float alpha, float roughness);

/// F of the chosen method at v.h.
[[nodiscard]] glm::vec3 fresnel_term(const CookTorranceSetup& setup, float v_dot_h, const glm::vec3& f0);

/// Kulla and Conty's lobe times n.l.
[[nodiscard]] glm::vec3 compensation_term(const CookTorranceSetup& setup, const MicrofacetSurface& surface,
                                          float n_dot_l, float n_dot_v);

/// The model of one light at one point. n, l, v unit; m: the material's constants; surface: what may vary from point to
/// point. A light behind the surface adds nothing; a viewer behind it (the interpolated normal of a silhouette) counts
/// as n.v = 0.
[[nodiscard]] ReflectedTerms cook_torrance(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v,
                                           const CookTorranceSetup& m, const MicrofacetSurface& surface);
/// Diffuse and specular reflection of one light at one point; n, l, v unit, world space. Equation (1) of
/// docs/42_cook_torrance.md.
[[nodiscard]] ReflectedTerms cook_torrance(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v,
                                           const CookTorranceSetup& m);

}  // namespace kreda::lighting
