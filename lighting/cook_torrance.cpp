#include "lighting/cook_torrance.hpp"

#include "lighting/microfacet_choices.hpp"
#include "raster/platform.hpp"

namespace kreda::lighting {

namespace {

/// n and k of one index a channel, relative to the medium before the surface.
void set_index(CookTorranceSetup& setup, const glm::vec3& n, const glm::vec3& k, float outside_ior) {
    setup.has_index = true;
    setup.n = n / outside_ior;
    setup.k = k / outside_ior;
    setup.absorbs = k != glm::vec3(0.0f);
    setup.surface.f0 = f0_from_index(setup.n, setup.k);
    setup.f82_b = f82_coefficient_from_index(setup.n, setup.k);
}

void set_measured(CookTorranceSetup& setup, const CookTorranceMaterial& material) {
    const MeasuredMaterial* const measured = find_measured(material.measured);
    KREDA_EXPECT(measured);
    const ThreeChannelIndex index = three_channel_index(*measured);
    set_index(setup, index.n, index.k, material.outside_ior);
    setup.all_wavelengths = material.spectrum == SpectrumUse::full;
    if (!setup.all_wavelengths) return;
    setup.spectrum = spectral_index(*measured, material.outside_ior);
    const SpectralColors colors = spectral_colors(setup.spectrum);
    setup.surface.f0 = colors.f0;
    setup.f82_b = colors.b;
}

void prepare_correction(CookTorranceSetup& setup) {
    const bool as_printed = setup.fresnel == FresnelMethod::corrected_schlick_as_printed;
    for (int channel = 0; channel < 3; ++channel) {
        const float n = setup.n[channel];
        const float k = setup.k[channel];
        const SchlickCorrection fit = as_printed ? fit_correction_as_printed(n, k) : fit_correction(n, k);
        setup.correction_a[channel] = fit.a;
        setup.correction_lambda[channel] = fit.lambda;
    }
}

/// b of F82 from the colour that was given for c = 1/7.
void set_f82(CookTorranceSetup& setup, const glm::vec3& f82) {
    for (int i = 0; i < 3; ++i) setup.f82_b[i] = f82_coefficient(setup.surface.f0[i], f82[i]);
}

/// 2 int_0^1 F(mu) mu dmu of the chosen method, less that of Schlick's. Midpoints: error 1e-5.
glm::vec3 average_beyond_schlick(const CookTorranceSetup& setup) {
    constexpr int kSteps = 256;
    const glm::vec3 f0 = setup.surface.f0;
    glm::vec3 sum{0.0f};
    for (int i = 0; i < kSteps; ++i) {
        const float mu = (static_cast<float>(i) + 0.5f) / kSteps;
        sum += (fresnel_term(setup, mu, f0) - fresnel_schlick(mu, f0)) * (2.0f * mu / kSteps);
    }
    return sum;
}

}  // namespace

bool needs_three_indices(FresnelMethod method) {
    return method == FresnelMethod::schlick_ior || method == FresnelMethod::rescaled_schlick ||
           method == FresnelMethod::corrected_schlick || method == FresnelMethod::corrected_schlick_as_printed;
}

CookTorranceSetup prepare(const CookTorranceMaterial& material) {
    CookTorranceSetup setup;
    setup.distribution = material.distribution;
    setup.geometry = material.geometry;
    setup.fresnel = material.fresnel;
    setup.energy_compensation = material.energy_compensation;
    if (!material.measured.empty()) {
        set_measured(setup, material);
    } else if (material.ior) {
        set_index(setup, *material.ior, material.extinction.value_or(glm::vec3(0.0f)), material.outside_ior);
    }
    setup.surface = surface_from_maps(material.albedo, material.metallic, material.roughness, setup);
    if (!setup.has_index) setup.n = index_from_f0(setup.surface.f0);

    if (material.f82) set_f82(setup, *material.f82);
    prepare_correction(setup);
    setup.has_bias = material.nvidia.has_value();
    if (setup.has_bias) setup.nvidia = *material.nvidia;
    if (material.fresnel == FresnelMethod::table) {
        setup.table = setup.all_wavelengths ? spectral_fresnel_table(setup.spectrum, material.table_size)
                                            : fresnel_table(setup.n, setup.k, material.table_size);
    }
    if (material.energy_compensation == EnergyCompensation::kulla_conty) {
        setup.energy = compute_energy_table(material.distribution, material.geometry);
        setup.f_avg_shift = average_beyond_schlick(setup);
    }
    return setup;
}

FormulaFacts fresnel_facts(const CookTorranceSetup& setup) {
    FormulaFacts facts = facts_of(setup.fresnel);
    if (setup.fresnel == FresnelMethod::nvidia && setup.has_bias) {
        facts.text = "bias + scale (1 - v·h)^power, cut to 0..1";
    }
    if (setup.fresnel != FresnelMethod::exact) return facts;
    facts.name = setup.all_wavelengths ? "exact, whole spectrum"
                 : setup.absorbs       ? "exact, conductor"
                                       : "exact, dielectric";
    facts.text = setup.all_wavelengths ? "mean over wavelengths of (R_s + R_p) / 2 from n, k and v·h"
                 : setup.absorbs       ? "(R_s + R_p) / 2  from n, k and v·h"
                 : setup.has_index     ? "(R_s + R_p) / 2  from n and v·h"
                                       : "(R_s + R_p) / 2  from n(F0) and v·h";
    if (setup.all_wavelengths) facts.operations = kSpectralFresnelOperations;
    return facts;
}

float distribution_term(Distribution distribution, const MicrofacetAngles& a, float alpha) {
    return with_distribution(distribution, [&](auto D) { return D(a.n_dot_h, a.sin2_h, alpha); });
}

float visibility_term(Geometry geometry, const MicrofacetAngles& a, float alpha, float roughness) {
    return with_visibility(geometry, LitBy::lamp, [&](auto V) { return V(a, alpha, roughness); });
}

glm::vec3 fresnel_term(const CookTorranceSetup& setup, float v_dot_h, const glm::vec3& f0) {
    return with_fresnel(setup, [&](auto F) { return F(v_dot_h, f0); });
}

glm::vec3 compensation_term(const CookTorranceSetup& setup, const MicrofacetSurface& surface, float n_dot_l,
                            float n_dot_v) {
    const float E_l = directional_albedo(setup.energy, n_dot_l, surface.roughness);
    const float E_v = directional_albedo(setup.energy, n_dot_v, surface.roughness);
    const float E_avg = average_albedo(setup.energy, surface.roughness);
    const float f_ms = multiple_scattering(E_l, E_v, E_avg);
    const glm::vec3 F_ms = multiple_scattering_color(surface.f0, setup.f_avg_shift, E_avg);
    return F_ms * (f_ms * n_dot_l);
}

ReflectedTerms cook_torrance(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const CookTorranceSetup& m,
                             const MicrofacetSurface& surface) {
    const MicrofacetAngles angles = microfacet_angles(n, l, v);
    const float D = distribution_term(m.distribution, angles, surface.alpha);
    const float V = visibility_term(m.geometry, angles, surface.alpha, surface.roughness);
    const glm::vec3 F = fresnel_term(m, angles.v_dot_h, surface.f0);
    ReflectedTerms terms = combine_terms(angles.n_dot_l, D, V, F, surface.albedo, surface.metallic);
    if (m.energy_compensation == EnergyCompensation::kulla_conty) {
        terms.specular += compensation_term(m, surface, angles.n_dot_l, angles.n_dot_v);
    }
    return terms;
}

ReflectedTerms cook_torrance(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const CookTorranceSetup& m) {
    return cook_torrance(n, l, v, m, m.surface);
}

}  // namespace kreda::lighting
