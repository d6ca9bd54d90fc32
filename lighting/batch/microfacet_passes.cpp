#include "lighting/batch/microfacet_passes.hpp"

#include "lighting/batch/add_light.hpp"
#include "raster/platform.hpp"

namespace kreda::lighting {

namespace {

using raster::lanes_for;

KREDA_BATCH_LOOP void fill_channels(int lanes, MicrofacetSurface even, SurfaceChannels& surface) {
    for (int i = 0; i < lanes; ++i) {
        surface.albedo.set(i, even.albedo);
        surface.f0.set(i, even.f0);
        surface.metallic.set(i, even.metallic);
        surface.roughness.set(i, even.roughness);
        surface.alpha.set(i, even.alpha);
    }
}

KREDA_BATCH_LOOP void set_n_dot_v(int lanes, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) c.microfacet.n_dot_v.set(i, raster::saturate(glm::dot(c.n.at(i), c.v.at(i))));
}

KREDA_BATCH_LOOP void set_angles(int lanes, LightingChannels& c) {
    MicrofacetChannels& m = c.microfacet;
    with_quantity(c.l, [&](auto l) {
        for (int i = 0; i < lanes; ++i) {  // 2 formulas
            const HalfVectorAngles a = half_vector_angles(c.n.at(i), l(i), c.v.at(i));
            m.n_dot_l.set(i, raster::saturate(c.n_dot_l.at(i)));
            m.n_dot_h.set(i, a.n_dot_h);
            m.v_dot_h.set(i, a.v_dot_h);
            m.sin2_h.set(i, a.sin2_h);
        }
    });
}

KREDA_BATCH_LOOP void set_distribution(int lanes, Distribution distribution, MicrofacetChannels& m) {
    with_distribution(distribution, [&](auto D) {
        with_surface(m.surface, [&](auto surface) {
            for (int i = 0; i < lanes; ++i) {  // 8 formulas
                m.D.set(i, D(m.n_dot_h.at(i), m.sin2_h.at(i), surface(i).alpha));
            }
        });
    });
}

KREDA_BATCH_LOOP void set_visibility(int lanes, Geometry geometry, LitBy lit_by, MicrofacetChannels& m) {
    with_visibility(geometry, lit_by, [&](auto V) {
        with_surface(m.surface, [&](auto surface) {
            for (int i = 0; i < lanes; ++i) {  // 12 formulas
                const MicrofacetAngles angles{m.n_dot_l.at(i), m.n_dot_v.at(i), m.n_dot_h.at(i), m.v_dot_h.at(i),
                                              m.sin2_h.at(i)};
                m.V.set(i, V(angles, surface(i).alpha, surface(i).roughness));
            }
        });
    });
}

/// Wavelength after wavelength, each over the whole batch: the sums stay in the order of spectral_fresnel.
KREDA_BATCH_LOOP void add_wavelength(int lanes, const SpectralIndex& index, std::size_t w, MicrofacetChannels& m) {
    const glm::vec3 color = index.color[w];
    const float n = index.n[w], k = index.k[w];
    for (int i = 0; i < lanes; ++i) m.F.set(i, m.F.at(i) + reflected_at(m.v_dot_h.at(i), color, n, k));
}

KREDA_BATCH_LOOP void start_spectrum(int lanes, MicrofacetChannels& m) {
    for (int i = 0; i < lanes; ++i) m.F.set(i, glm::vec3(0.0f));  // not vectorized: GCC makes it calls of memset
}

void set_spectral(int lanes, const SpectralIndex& index, MicrofacetChannels& m) {
    start_spectrum(lanes, m);
    for (std::size_t w = 0; w < index.n.size(); ++w) add_wavelength(lanes, index, w, m);
}

KREDA_BATCH_LOOP void set_at_one_index(int lanes, const CookTorranceSetup& setup, MicrofacetChannels& m) {
    with_fresnel(setup, [&](auto F) {
        with_surface(m.surface, [&](auto surface) {
            for (int i = 0; i < lanes; ++i) {  // 22 formulas: a look-up in a table and a copy of F0 are none of them
                m.F.set(i, F(m.v_dot_h.at(i), surface(i).f0));
            }
        });
    });
}

void set_fresnel(int lanes, const CookTorranceSetup& setup, MicrofacetChannels& m) {
    if (setup.fresnel == FresnelMethod::exact && setup.all_wavelengths) return set_spectral(lanes, setup.spectrum, m);
    set_at_one_index(lanes, setup, m);
}

// ---------------------------------------------------------------------------------------------------------- sum

KREDA_BATCH_LOOP void add_light(int lanes, LightingChannels& c) {
    const MicrofacetChannels& m = c.microfacet;
    with_adder(c, [&](auto add) {
        with_surface(m.surface, [&](auto surface) {
            for (int i = 0; i < lanes; ++i) {  // 16 formulas
                add(i, combine_terms(m.n_dot_l.at(i), m.D.at(i), m.V.at(i), m.F.at(i), surface(i).albedo,
                                     surface(i).metallic));
            }
        });
    });
}

KREDA_BATCH_LOOP void add_compensation(int lanes, const CookTorranceSetup& setup, LightingChannels& c) {
    const MicrofacetChannels& m = c.microfacet;
    for (int i = 0; i < lanes; ++i) {  // not vectorized: an option, and most of it are look-ups in a table
        const glm::vec3 f_ms = compensation_term(setup, m.surface.at(i), m.n_dot_l.at(i), m.n_dot_v.at(i));
        c.specular.set(i, c.specular.at(i) + c.irradiance.at(i) * f_ms);
    }
}

}  // namespace

void fill_surface(int count, SurfaceChannels& surface) {
    if (surface.is_even) fill_channels(lanes_for(count), surface.even, surface);
    surface.is_even = false;
}

void set_viewing_angle(int count, LightingChannels& channels) {
    set_n_dot_v(lanes_for(count), channels);
}

void evaluate_microfacets(int count, const CookTorranceSetup& setup, LitBy lit_by, LightingChannels& channels) {
    const int lanes = lanes_for(count);
    set_angles(lanes, channels);
    set_distribution(lanes, setup.distribution, channels.microfacet);
    set_visibility(lanes, setup.geometry, lit_by, channels.microfacet);
    set_fresnel(lanes, setup, channels.microfacet);
}

void evaluate_fresnel(int count, const CookTorranceSetup& setup, MicrofacetChannels& channels) {
    set_fresnel(lanes_for(count), setup, channels);
}

void add_cook_torrance(int count, const CookTorranceSetup& setup, LightingChannels& channels) {
    const int lanes = lanes_for(count);
    const bool compensates = setup.energy_compensation == EnergyCompensation::kulla_conty;
    if (compensates) channels.is_last = false;  // something follows
    evaluate_microfacets(count, setup, LitBy::lamp, channels);
    add_light(lanes, channels);
    if (compensates) add_compensation(lanes, setup, channels);
}

}  // namespace kreda::lighting
