// The constants of Cook and Torrance's model as plain data: what is computed once for a material. The formulas are
// lighting/cook_torrance.hpp and what it includes: the data stand apart, so that whoever changes a formula need not
// wait until everything that carries a material is compiled again.
#pragma once

#include <glm/vec3.hpp>

#include "lighting/material.hpp"
#include "lighting/tables.hpp"

namespace kreda::lighting {

/// F0 of a dielectric whose index is not given: n = 1.5.
inline constexpr float kDielectricF0 = 0.04f;

/// What may vary from point to point (maps), ready for the formulas.
struct MicrofacetSurface {
    glm::vec3 albedo{0.8f};       ///< c, linear RGB, 0..1
    glm::vec3 f0{kDielectricF0};  ///< F at normal incidence, linear RGB, 0..1
    float metallic = 0.0f;        ///< 0 dielectric, 1 metal
    float roughness = 0.5f;       ///< perceptual, 0..1; alpha = roughness^2
    float alpha = 0.25f;          ///< alpha_from_roughness
};

/// Constants of a material, computed once by prepare().
struct CookTorranceSetup {
    Distribution distribution = Distribution::ggx;   ///< D
    Geometry geometry = Geometry::schlick_ggx;       ///< G
    FresnelMethod fresnel = FresnelMethod::schlick;  ///< F
    EnergyCompensation energy_compensation =
        EnergyCompensation::none;        ///< what replaces the light that single reflection loses
    bool has_index = false;              ///< n and k are known: F0 comes from them, not from albedo and metallic
    bool absorbs = false;                ///< a k is not 0: a metal; else exact is the cheaper formula of dielectrics
    bool all_wavelengths = false;        ///< they are known for the whole spectrum: exact sums over it
    MicrofacetSurface surface;           ///< where no map says otherwise
    glm::vec3 n{1.5f};                   ///< exact: relative to the outside; or the dielectric with this F0
    glm::vec3 k{0.0f};                   ///< exact: extinction, >= 0; 0: a dielectric
    SpectralIndex spectrum;              ///< all_wavelengths
    glm::vec3 correction_a{0.0f};        ///< corrected_schlick
    glm::vec3 correction_lambda{1.0f};   ///< corrected_schlick
    glm::vec3 f82_b{0.0f};               ///< f82; 0 without n and k: then it is Schlick
    bool has_bias = false;               ///< nvidia: bias and scale were given; else F0, 1 - F0
    glm::vec3 nvidia{0.0f, 1.0f, 5.0f};  ///< bias, scale, power
    FresnelTable table;                  ///< table
    glm::vec3 f_avg_shift{0.0f};         ///< average of F minus that of Schlick's with the same F0 (compensation)
    EnergyTable energy;                  ///< kulla_conty
};

/// Requires, if material.measured is not empty, that find_measured knows it.
[[nodiscard]] CookTorranceSetup prepare(const CookTorranceMaterial& material);

/// Methods fitted to one n and k a channel: for a measured material they need spectrum = three.
[[nodiscard]] bool needs_three_indices(FresnelMethod method);

}  // namespace kreda::lighting
