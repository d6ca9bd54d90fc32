#include "lighting/cook_torrance.hpp"

#include "raster/platform.hpp"

namespace kreda::lighting {

namespace {

void prepare_correction(CookTorranceSetup& setup) {
    for (int channel = 0; channel < 3; ++channel) {
        const SchlickCorrection fit = fit_correction(setup.n[channel], setup.k[channel]);
        setup.correction_a[channel] = fit.a;
        setup.correction_lambda[channel] = fit.lambda;
    }
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

CookTorranceSetup prepare(const CookTorranceMaterial& material) {
    CookTorranceSetup setup;
    setup.distribution = material.distribution;
    setup.geometry = material.geometry;
    setup.fresnel = material.fresnel;
    setup.energy_compensation = material.energy_compensation;
    setup.has_index = material.ior.has_value();
    setup.k = material.extinction.value_or(glm::vec3(0.0f));
    if (setup.has_index) setup.surface.f0 = f0_from_index(*material.ior, setup.k);
    setup.surface = surface_from_maps(material.albedo, material.metallic, material.roughness, setup);
    setup.n = setup.has_index ? *material.ior : index_from_f0(setup.surface.f0);
    if (!setup.has_index) setup.k = glm::vec3(0.0f);

    if (setup.has_index) setup.f82_b = f82_coefficient_from_index(setup.n, setup.k);
    if (material.fresnel == FresnelMethod::corrected_schlick) prepare_correction(setup);
    if (material.fresnel == FresnelMethod::table) setup.table = fresnel_table(setup.n, setup.k);
    if (material.energy_compensation == EnergyCompensation::kulla_conty) {
        setup.energy = compute_energy_table(material.distribution, material.geometry);
        setup.f_avg_shift = average_beyond_schlick(setup);
    }
    return setup;
}

float distribution_term(Distribution distribution, const MicrofacetAngles& a, float alpha) {
    switch (distribution) {
        case Distribution::ggx:
            return ggx_distribution(a.n_dot_h, a.sin2_h, alpha);
        case Distribution::beckmann:
            return beckmann_distribution(a.n_dot_h, a.sin2_h, alpha);
        case Distribution::blinn_phong:
            return blinn_phong_distribution(a.n_dot_h, a.sin2_h, alpha);
        case Distribution::gaussian:
            return gaussian_distribution(a.n_dot_h, a.sin2_h, alpha);
    }
    return 0.0f;
}

float visibility_term(Geometry geometry, const MicrofacetAngles& a, float alpha, float roughness) {
    switch (geometry) {
        case Geometry::schlick_ggx:
            return schlick_ggx_visibility(a.n_dot_l, a.n_dot_v, schlick_k_direct(roughness));
        case Geometry::smith:
            return smith_visibility(a.n_dot_l, a.n_dot_v, alpha);
        case Geometry::smith_correlated:
            return smith_correlated_visibility(a.n_dot_l, a.n_dot_v, alpha);
        case Geometry::implicit:
            return implicit_visibility();
        case Geometry::cook_torrance:
            return cook_torrance_visibility(a.n_dot_l, a.n_dot_v, a.n_dot_h, a.v_dot_h);
    }
    return 0.0f;
}

glm::vec3 fresnel_term(const CookTorranceSetup& setup, float c, const glm::vec3& f0) {
    switch (setup.fresnel) {
        case FresnelMethod::schlick:
        case FresnelMethod::rescaled_schlick:
            return fresnel_schlick(c, f0);  // the same, see fresnel_rescaled_schlick
        case FresnelMethod::exact:
            return setup.has_index ? fresnel_conductor(c, setup.n, setup.k) : fresnel_dielectric(c, index_from_f0(f0));
        case FresnelMethod::corrected_schlick:
            return fresnel_corrected_schlick(c, f0, setup.correction_a, setup.correction_lambda);
        case FresnelMethod::f82:
            return fresnel_f82(c, f0, setup.f82_b);
        case FresnelMethod::table:
            return fresnel_lookup(c, setup.table);
        case FresnelMethod::nvidia:
            return fresnel_nvidia(c, f0, 1.0f - f0, setup.nvidia_power);
        case FresnelMethod::none:
            return f0;
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
