#include "lighting/batch/microfacet_passes.hpp"

#include "raster/platform.hpp"

namespace kreda::lighting {

namespace {

using raster::lanes_for;

KREDA_BATCH_LOOP void fill_constants(int lanes, const MicrofacetSurface& surface, MicrofacetChannels& m) {
    const MicrofacetSurface s = surface;
    for (int i = 0; i < lanes; ++i) {
        m.albedo.set(i, s.albedo);
        m.f0.set(i, s.f0);
        m.metallic.set(i, s.metallic);
        m.roughness.set(i, s.roughness);
        m.alpha.set(i, s.alpha);
    }
}

KREDA_BATCH_LOOP void find_n_dot_v(int lanes, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) c.microfacet.n_dot_v.set(i, raster::saturate(glm::dot(c.n.at(i), c.v.at(i))));
}

KREDA_BATCH_LOOP void find_angles(int lanes, LightingChannels& c) {
    MicrofacetChannels& m = c.microfacet;
    for (int i = 0; i < lanes; ++i) {
        const HalfVectorAngles a = half_vector_angles(c.n.at(i), c.l.at(i), c.v.at(i));
        m.n_dot_l.set(i, raster::saturate(c.n_dot_l.at(i)));
        m.n_dot_h.set(i, a.n_dot_h);
        m.v_dot_h.set(i, a.v_dot_h);
        m.sin2_h.set(i, a.sin2_h);
    }
}

// ------------------------------------------------------------------------------------------------------------ D

KREDA_BATCH_LOOP void find_ggx(int lanes, MicrofacetChannels& m) {
    for (int i = 0; i < lanes; ++i) m.D.set(i, ggx_distribution(m.n_dot_h.at(i), m.sin2_h.at(i), m.alpha.at(i)));
}

KREDA_BATCH_LOOP void find_beckmann(int lanes, MicrofacetChannels& m) {
    for (int i = 0; i < lanes; ++i) m.D.set(i, beckmann_distribution(m.n_dot_h.at(i), m.sin2_h.at(i), m.alpha.at(i)));
}

KREDA_BATCH_LOOP void find_blinn_phong(int lanes, MicrofacetChannels& m) {
    for (int i = 0; i < lanes; ++i) {
        m.D.set(i, blinn_phong_distribution(m.n_dot_h.at(i), m.sin2_h.at(i), m.alpha.at(i)));
    }
}

KREDA_BATCH_LOOP void find_gaussian(int lanes, MicrofacetChannels& m) {
    for (int i = 0; i < lanes; ++i) m.D.set(i, gaussian_distribution(m.n_dot_h.at(i), m.sin2_h.at(i), m.alpha.at(i)));
}

void find_distribution(int lanes, Distribution distribution, MicrofacetChannels& m) {
    switch (distribution) {
        case Distribution::ggx: return find_ggx(lanes, m);
        case Distribution::beckmann: return find_beckmann(lanes, m);
        case Distribution::blinn_phong: return find_blinn_phong(lanes, m);
        case Distribution::gaussian: return find_gaussian(lanes, m);
    }
}

// ------------------------------------------------------------------------------------------------------------ V

KREDA_BATCH_LOOP void find_schlick_ggx(int lanes, MicrofacetChannels& m) {
    for (int i = 0; i < lanes; ++i) {
        const float k = schlick_k_direct(m.roughness.at(i));
        m.V.set(i, schlick_ggx_visibility(m.n_dot_l.at(i), m.n_dot_v.at(i), k));
    }
}

KREDA_BATCH_LOOP void find_schlick_ggx_of_image(int lanes, MicrofacetChannels& m) {
    for (int i = 0; i < lanes; ++i) {
        const float k = schlick_k_image(m.alpha.at(i));
        m.V.set(i, schlick_ggx_visibility(m.n_dot_l.at(i), m.n_dot_v.at(i), k));
    }
}

KREDA_BATCH_LOOP void find_smith(int lanes, MicrofacetChannels& m) {
    for (int i = 0; i < lanes; ++i) m.V.set(i, smith_visibility(m.n_dot_l.at(i), m.n_dot_v.at(i), m.alpha.at(i)));
}

KREDA_BATCH_LOOP void find_smith_correlated(int lanes, MicrofacetChannels& m) {
    for (int i = 0; i < lanes; ++i) {
        m.V.set(i, smith_correlated_visibility(m.n_dot_l.at(i), m.n_dot_v.at(i), m.alpha.at(i)));
    }
}

KREDA_BATCH_LOOP void find_implicit(int lanes, MicrofacetChannels& m) {
    for (int i = 0; i < lanes; ++i) m.V.set(i, implicit_visibility());
}

KREDA_BATCH_LOOP void find_grooves(int lanes, MicrofacetChannels& m) {
    for (int i = 0; i < lanes; ++i) {
        m.V.set(i, cook_torrance_visibility(m.n_dot_l.at(i), m.n_dot_v.at(i), m.n_dot_h.at(i), m.v_dot_h.at(i)));
    }
}

void find_visibility(int lanes, Geometry geometry, LightKind kind, MicrofacetChannels& m) {
    switch (geometry) {
        case Geometry::schlick_ggx:
            return kind == LightKind::lamp ? find_schlick_ggx(lanes, m) : find_schlick_ggx_of_image(lanes, m);
        case Geometry::smith: return find_smith(lanes, m);
        case Geometry::smith_correlated: return find_smith_correlated(lanes, m);
        case Geometry::implicit: return find_implicit(lanes, m);
        case Geometry::cook_torrance: return find_grooves(lanes, m);
    }
}

// ------------------------------------------------------------------------------------------------------------ F

KREDA_BATCH_LOOP void find_schlick(int lanes, MicrofacetChannels& m) {
    for (int i = 0; i < lanes; ++i) m.F.set(i, fresnel_schlick(m.v_dot_h.at(i), m.f0.at(i)));
}

KREDA_BATCH_LOOP void find_conductor(int lanes, const glm::vec3& n, const glm::vec3& k, MicrofacetChannels& m) {
    const glm::vec3 index = n;
    const glm::vec3 extinction = k;
    for (int i = 0; i < lanes; ++i) m.F.set(i, fresnel_conductor(m.v_dot_h.at(i), index, extinction));
}

KREDA_BATCH_LOOP void find_dielectric(int lanes, const glm::vec3& n, MicrofacetChannels& m) {
    const glm::vec3 index = n;
    for (int i = 0; i < lanes; ++i) m.F.set(i, fresnel_dielectric(m.v_dot_h.at(i), index));
}

KREDA_BATCH_LOOP void find_dielectric_from_f0(int lanes, MicrofacetChannels& m) {
    for (int i = 0; i < lanes; ++i) m.F.set(i, fresnel_dielectric(m.v_dot_h.at(i), index_from_f0(m.f0.at(i))));
}

/// Wavelength after wavelength, each over the whole batch: the sums stay in the order of spectral_fresnel.
KREDA_BATCH_LOOP void add_wavelength(int lanes, const glm::vec3& color, float n, float k, MicrofacetChannels& m) {
    const glm::vec3 share = color;
    for (int i = 0; i < lanes; ++i) m.F.set(i, m.F.at(i) + share * fresnel_conductor(m.v_dot_h.at(i), n, k));
}

KREDA_BATCH_LOOP void start_spectrum(int lanes, MicrofacetChannels& m) {
    for (int i = 0; i < lanes; ++i) m.F.set(i, glm::vec3(0.0f));  // not vectorized: GCC makes it calls of memset
}

void find_spectral(int lanes, const SpectralIndex& index, MicrofacetChannels& m) {
    start_spectrum(lanes, m);
    for (std::size_t w = 0; w < index.n.size(); ++w) add_wavelength(lanes, index.color[w], index.n[w], index.k[w], m);
}

void find_exact(int lanes, const CookTorranceSetup& setup, MicrofacetChannels& m) {
    if (setup.all_wavelengths) return find_spectral(lanes, setup.spectrum, m);
    if (setup.absorbs) return find_conductor(lanes, setup.n, setup.k, m);
    if (setup.has_index) return find_dielectric(lanes, setup.n, m);
    find_dielectric_from_f0(lanes, m);
}

KREDA_BATCH_LOOP void find_schlick_between(int lanes, const glm::vec3& n, MicrofacetChannels& m) {
    const glm::vec3 index = n;
    for (int i = 0; i < lanes; ++i) m.F.set(i, fresnel_schlick_between(m.v_dot_h.at(i), index));
}

KREDA_BATCH_LOOP void find_schlick_between_from_f0(int lanes, MicrofacetChannels& m) {
    for (int i = 0; i < lanes; ++i) { m.F.set(i, fresnel_schlick_between(m.v_dot_h.at(i), index_from_f0(m.f0.at(i)))); }
}

KREDA_BATCH_LOOP void find_corrected(int lanes, const glm::vec3& a, const glm::vec3& lambda, MicrofacetChannels& m) {
    const glm::vec3 factor = a;
    const glm::vec3 power = lambda;
    for (int i = 0; i < lanes; ++i) {
        m.F.set(i, fresnel_corrected_schlick(m.v_dot_h.at(i), m.f0.at(i), factor, power));
    }
}

KREDA_BATCH_LOOP void find_corrected_as_printed(int lanes, const glm::vec3& a, const glm::vec3& lambda,
                                                MicrofacetChannels& m) {
    const glm::vec3 factor = a;
    const glm::vec3 power = lambda;
    for (int i = 0; i < lanes; ++i) {
        m.F.set(i, fresnel_corrected_schlick_as_printed(m.v_dot_h.at(i), m.f0.at(i), factor, power));
    }
}

KREDA_BATCH_LOOP void find_f82(int lanes, const glm::vec3& b, MicrofacetChannels& m) {
    const glm::vec3 coefficient = b;
    for (int i = 0; i < lanes; ++i) m.F.set(i, fresnel_f82(m.v_dot_h.at(i), m.f0.at(i), coefficient));
}

KREDA_BATCH_LOOP void find_in_table(int lanes, const FresnelTable& table, MicrofacetChannels& m) {
    const float* const r = table.r.data();
    const float* const g = table.g.data();
    const float* const b = table.b.data();
    const int size = table.size();
    for (int i = 0; i < lanes; ++i) {  // not vectorized: each look-up goes to its own place in the table
        const float c = m.v_dot_h.at(i);
        m.F.set(i, {fresnel_lookup(c, r, size), fresnel_lookup(c, g, size), fresnel_lookup(c, b, size)});
    }
}

KREDA_BATCH_LOOP void find_nvidia(int lanes, float power, MicrofacetChannels& m) {
    for (int i = 0; i < lanes; ++i) {
        const glm::vec3 f0 = m.f0.at(i);
        m.F.set(i, fresnel_nvidia(m.v_dot_h.at(i), f0, 1.0f - f0, power));
    }
}

KREDA_BATCH_LOOP void find_nvidia_as_given(int lanes, const glm::vec3& bias_scale_power, MicrofacetChannels& m) {
    const float bias = bias_scale_power.x;
    const float scale = bias_scale_power.y;
    const float power = bias_scale_power.z;
    for (int i = 0; i < lanes; ++i) m.F.set(i, glm::vec3(fresnel_nvidia(m.v_dot_h.at(i), bias, scale, power)));
}

KREDA_BATCH_LOOP void find_constant(int lanes, MicrofacetChannels& m) {
    for (int i = 0; i < lanes; ++i) m.F.set(i, m.f0.at(i));  // not vectorized: GCC makes it calls of memcpy
}

void find_fresnel(int lanes, const CookTorranceSetup& setup, MicrofacetChannels& m) {
    switch (setup.fresnel) {
        case FresnelMethod::schlick:
        case FresnelMethod::rescaled_schlick: return find_schlick(lanes, m);
        case FresnelMethod::exact: return find_exact(lanes, setup, m);
        case FresnelMethod::schlick_ior:
            return setup.has_index ? find_schlick_between(lanes, setup.n, m) : find_schlick_between_from_f0(lanes, m);
        case FresnelMethod::corrected_schlick:
            return find_corrected(lanes, setup.correction_a, setup.correction_lambda, m);
        case FresnelMethod::corrected_schlick_as_printed:
            return find_corrected_as_printed(lanes, setup.correction_a, setup.correction_lambda, m);
        case FresnelMethod::f82: return find_f82(lanes, setup.f82_b, m);
        case FresnelMethod::table: return find_in_table(lanes, setup.table, m);
        case FresnelMethod::nvidia:
            if (setup.has_bias) return find_nvidia_as_given(lanes, setup.nvidia, m);
            return find_nvidia(lanes, setup.nvidia.z, m);
        case FresnelMethod::none: return find_constant(lanes, m);
    }
}

// ---------------------------------------------------------------------------------------------------------- sum

KREDA_BATCH_LOOP void add_light(int lanes, LightingChannels& c) {
    const MicrofacetChannels& m = c.microfacet;
    for (int i = 0; i < lanes; ++i) {
        const ReflectedTerms terms =
            combine_terms(m.n_dot_l.at(i), m.D.at(i), m.V.at(i), m.F.at(i), m.albedo.at(i), m.metallic.at(i));
        add_terms(c, i, terms);
    }
}

KREDA_BATCH_LOOP void add_compensation(int lanes, const CookTorranceSetup& setup, LightingChannels& c) {
    const MicrofacetChannels& m = c.microfacet;
    for (int i = 0; i < lanes; ++i) {  // not vectorized: an option, and most of it are look-ups in a table
        MicrofacetSurface surface;
        surface.f0 = m.f0.at(i);
        surface.roughness = m.roughness.at(i);
        const glm::vec3 f_ms = compensation_term(setup, surface, m.n_dot_l.at(i), m.n_dot_v.at(i));
        c.specular.set(i, c.specular.at(i) + c.irradiance.at(i) * f_ms);
    }
}

}  // namespace

void fill_surface(int count, const CookTorranceSetup& setup, MicrofacetChannels& channels) {
    fill_constants(lanes_for(count), setup.surface, channels);
}

void find_viewing_angle(int count, LightingChannels& channels) {
    find_n_dot_v(lanes_for(count), channels);
}

void evaluate_microfacets(int count, const CookTorranceSetup& setup, LightKind kind, LightingChannels& channels) {
    const int lanes = lanes_for(count);
    find_angles(lanes, channels);
    find_distribution(lanes, setup.distribution, channels.microfacet);
    find_visibility(lanes, setup.geometry, kind, channels.microfacet);
    find_fresnel(lanes, setup, channels.microfacet);
}

void evaluate_fresnel(int count, const CookTorranceSetup& setup, MicrofacetChannels& channels) {
    find_fresnel(lanes_for(count), setup, channels);
}

void add_cook_torrance(int count, const CookTorranceSetup& setup, LightingChannels& channels) {
    const int lanes = lanes_for(count);
    evaluate_microfacets(count, setup, LightKind::lamp, channels);
    add_light(lanes, channels);
    if (setup.energy_compensation == EnergyCompensation::kulla_conty) add_compensation(lanes, setup, channels);
}

}  // namespace kreda::lighting
