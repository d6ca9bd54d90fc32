#include "lighting/cook_torrance.hpp"

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

float distribution_term(Distribution distribution, const MicrofacetAngles& a, float alpha) {
    switch (distribution) {
        case Distribution::ggx: return ggx_distribution(a.n_dot_h, a.sin2_h, alpha);
        case Distribution::beckmann: return beckmann_distribution(a.n_dot_h, a.sin2_h, alpha);
        case Distribution::blinn_phong: return blinn_phong_distribution(a.n_dot_h, a.sin2_h, alpha);
        case Distribution::gaussian: return gaussian_distribution(a.n_dot_h, a.sin2_h, alpha);
    }
    return 0.0f;
}

float visibility_term(Geometry geometry, const MicrofacetAngles& a, float alpha, float roughness) {
    switch (geometry) {
        case Geometry::schlick_ggx: return schlick_ggx_visibility(a.n_dot_l, a.n_dot_v, schlick_k_direct(roughness));
        case Geometry::smith: return smith_visibility(a.n_dot_l, a.n_dot_v, alpha);
        case Geometry::smith_correlated: return smith_correlated_visibility(a.n_dot_l, a.n_dot_v, alpha);
        case Geometry::implicit: return implicit_visibility();
        case Geometry::cook_torrance: return cook_torrance_visibility(a.n_dot_l, a.n_dot_v, a.n_dot_h, a.v_dot_h);
    }
    return 0.0f;
}

glm::vec3 fresnel_term(const CookTorranceSetup& setup, float c, const glm::vec3& f0) {
    switch (setup.fresnel) {
        case FresnelMethod::schlick:
        case FresnelMethod::rescaled_schlick: return fresnel_schlick(c, f0);  // the same, see fresnel_rescaled_schlick
        case FresnelMethod::exact:
            if (setup.all_wavelengths) return spectral_fresnel(c, setup.spectrum);
            if (setup.absorbs) return fresnel_conductor(c, setup.n, setup.k);
            return fresnel_dielectric(c, setup.has_index ? setup.n : index_from_f0(f0));
        case FresnelMethod::schlick_ior:
            return fresnel_schlick_between(c, setup.has_index ? setup.n : index_from_f0(f0));
        case FresnelMethod::corrected_schlick:
            return fresnel_corrected_schlick(c, f0, setup.correction_a, setup.correction_lambda);
        case FresnelMethod::corrected_schlick_as_printed:
            return fresnel_corrected_schlick_as_printed(c, f0, setup.correction_a, setup.correction_lambda);
        case FresnelMethod::f82: return fresnel_f82(c, f0, setup.f82_b);
        case FresnelMethod::table: return fresnel_lookup(c, setup.table);
        case FresnelMethod::nvidia:
            if (setup.has_bias) return glm::vec3(fresnel_nvidia(c, setup.nvidia.x, setup.nvidia.y, setup.nvidia.z));
            return fresnel_nvidia(c, f0, 1.0f - f0, setup.nvidia.z);
        case FresnelMethod::none: return f0;
    }
    return f0;
}

glm::vec3 compensation_term(const CookTorranceSetup& setup, const MicrofacetSurface& surface, float n_dot_l,
                            float n_dot_v) {
    const float E_l = directional_albedo(setup.energy, n_dot_l, surface.roughness);
    const float E_v = directional_albedo(setup.energy, n_dot_v, surface.roughness);
    const float E_avg = average_albedo(setup.energy, surface.roughness);
    const float f_ms = multiple_scattering(E_l, E_v, E_avg);
    glm::vec3 F_ms;
    for (int channel = 0; channel < 3; ++channel) {
        const float F_avg = average_schlick(surface.f0[channel]) + setup.f_avg_shift[channel];
        F_ms[channel] = multiple_scattering_color(F_avg, E_avg);
    }
    return F_ms * (f_ms * n_dot_l);
}

ReflectedTerms cook_torrance(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const CookTorranceSetup& setup,
                             const MicrofacetSurface& surface) {
    const MicrofacetAngles angles = microfacet_angles(n, l, v);
    const float D = distribution_term(setup.distribution, angles, surface.alpha);
    const float V = visibility_term(setup.geometry, angles, surface.alpha, surface.roughness);
    const glm::vec3 F = fresnel_term(setup, angles.v_dot_h, surface.f0);
    ReflectedTerms terms = combine_terms(angles.n_dot_l, D, V, F, surface.albedo, surface.metallic);
    if (setup.energy_compensation == EnergyCompensation::kulla_conty) {
        terms.specular += compensation_term(setup, surface, angles.n_dot_l, angles.n_dot_v);
    }
    return terms;
}

ReflectedTerms cook_torrance(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v,
                             const CookTorranceSetup& setup) {
    return cook_torrance(n, l, v, setup, setup.surface);
}

}  // namespace kreda::lighting
