#include "lighting/batch/environment_reference.hpp"

#include "lighting/batch/add_light.hpp"
#include "lighting/batch/microfacet_passes.hpp"
#include "lighting/environment/light_table.hpp"
#include "lighting/importance.hpp"
#include "raster/platform.hpp"

namespace kreda::lighting {

namespace {

using raster::lanes_for;

KREDA_BATCH_LOOP void start_reference(int lanes, EnvironmentChannels& e) {
    for (int i = 0; i < lanes; ++i) {  // not vectorized: GCC makes it calls of memset
        e.diffuse.set(i, glm::vec3(0.0f));
        e.specular.set(i, glm::vec3(0.0f));
    }
}

/// l of sample u: v mirrored in a facet that v sees.
KREDA_BATCH_LOOP void choose_mirrored(int lanes, glm::vec2 u, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) {
        const raster::OrthonormalFrame frame = frame_around(c.n.at(i));
        const glm::vec3 v = to_surface(frame, c.v.at(i));
        const glm::vec3 seen{v.x, v.y, v.z > 1e-4f ? v.z : 1e-4f};
        const glm::vec3 l = mirror_vector(visible_half_vector(u, seen, c.microfacet.surface.alpha.at(i)), seen);
        set_direction_to_light(c, i, unit(to_world(frame, l)));
    }
}

/// l of sample u, by its cosine.
KREDA_BATCH_LOOP void choose_by_cosine(int lanes, const glm::vec2& u, LightingChannels& c) {
    const glm::vec3 around = cosine_direction(u);
    for (int i = 0; i < lanes; ++i) { set_direction_to_light(c, i, unit(to_world(frame_around(c.n.at(i)), around))); }
}

/// What the samples of one way of choosing are worth, to say how far they scatter: x is the luminance of a sample.
struct SampleSums {
    raster::Channel x, sum, square;  ///< of the sample that is being added; of x and of x^2 over the samples
};

/// How likely the direction c.l is to be chosen by each of the ways [1/sr]; they hold something after look_along().
struct SampleDensities {
    alignas(64) std::int32_t texel[raster::kChannelSize];  ///< of the table, where `light` is read
    raster::Channel light;                                 ///< by the environment's light
    raster::Channel facet;                                 ///< by the facets that v sees; only for cook_torrance
};

inline float luminance(const glm::vec3& color) {
    return 0.2126f * color.x + 0.7152f * color.y + 0.0722f * color.z;
}

/// One over the densities of the two ways by which a direction might have been chosen: with the balance heuristic
///   w_a = p_a / (p_a + p_b),   w_a f / p_a = f / (p_a + p_b)                                 Veach & Guibas 1995
/// it does not matter by which of them it was.
inline float by_densities(float p_a, float p_b) {
    const float sum = p_a + p_b;
    return sum > 1e-30f ? 1.0f / sum : 0.0f;
}

/// p = n.l / pi
inline float cosine_density(const LightingChannels& c, int i) {
    return raster::saturate(c.n_dot_l.at(i)) * raster::kInvPi;
}

/// The same direction for all points, turned into the world.
KREDA_BATCH_LOOP void choose_light_direction(int lanes, const EnvironmentSetup& setup, const glm::vec3& on_map,
                                             LightingChannels& c) {
    const glm::vec3 l = map_direction(on_map, setup.cos_rotation, -setup.sin_rotation);
    for (int i = 0; i < lanes; ++i) set_direction_to_light(c, i, l);
}

KREDA_BATCH_LOOP void set_light_density(int lanes, const LightTable& light_table, const raster::Channel3& on_map,
                                        SampleDensities& p) {
    const int size = light_table.size;
    for (int i = 0; i < lanes; ++i) {
        const DensityTap tap = density_tap(size, on_map.at(i));
        p.texel[i] = tap.texel;
        p.light.set(i, tap.factor);
    }
    const float* density = light_table.density.data();
    for (int i = 0; i < lanes; ++i) p.light.value[i] *= density[p.texel[i]];  // not vectorized: reads here and there
}

/// p = D_GGX G_1(v) / (4 n.v) = D_GGX / (2 (n.v + root))
KREDA_BATCH_LOOP void set_facet_density(int lanes, const MicrofacetChannels& m, raster::Channel& density) {
    for (int i = 0; i < lanes; ++i) {
        const float alpha = m.surface.alpha.at(i), n_dot_v = m.n_dot_v.at(i);
        const float D = ggx_distribution(m.n_dot_h.at(i), m.sin2_h.at(i), alpha);
        density.set(i, D / (2.0f * (n_dot_v + smith_root(n_dot_v, alpha))));
    }
}

/// L along c.l into e.prefiltered, and how likely that direction is to be chosen.
void look_along(int count, const EnvironmentSetup& setup, LightingChannels& c, SampleDensities& p) {
    const raster::Channel3& on_map = look_at_environment(count, setup, c.l.each, c.environment);
    set_light_density(lanes_for(count), setup.maps->light, on_map, p);
}

/// ao D V F L (n.l)
KREDA_BATCH_LOOP void add_specular_sample(int lanes, float share, const SampleDensities& p, LightingChannels& c,
                                          SampleSums& sums) {
    const MicrofacetChannels& m = c.microfacet;
    EnvironmentChannels& e = c.environment;
    for (int i = 0; i < lanes; ++i) {
        const float weight = m.D.at(i) * by_densities(p.facet.at(i), p.light.at(i));
        const float reflected = weight * m.V.at(i) * m.n_dot_l.at(i) * m.ao.at(i);
        const glm::vec3 value = e.prefiltered.at(i) * m.F.at(i) * reflected;
        e.specular.set(i, e.specular.at(i) + value * share);
        sums.x.set(i, sums.x.at(i) + luminance(value));
    }
}

/// ao k_d c / pi L (n.l)
KREDA_BATCH_LOOP void add_diffuse_sample(int lanes, float share, const SampleDensities& p, LightingChannels& c,
                                         SampleSums& sums) {
    const MicrofacetChannels& m = c.microfacet;
    EnvironmentChannels& e = c.environment;
    for (int i = 0; i < lanes; ++i) {
        const glm::vec3 k_d = diffuse_share(m.F.at(i), m.surface.metallic.at(i));
        const float cosine = cosine_density(c, i);
        const float weight = cosine * by_densities(cosine, p.light.at(i)) * m.ao.at(i);
        const glm::vec3 value = k_d * m.surface.albedo.at(i) * e.prefiltered.at(i) * weight;
        e.diffuse.set(i, e.diffuse.at(i) + value * share);
        sums.x.set(i, sums.x.at(i) + luminance(value));
    }
}

/// L (n.l); the scatter is that of E / pi, what a white surface shows.
KREDA_BATCH_LOOP void add_irradiance_sample(int lanes, float share, const SampleDensities& p, LightingChannels& c,
                                            SampleSums& sums) {
    EnvironmentChannels& e = c.environment;
    for (int i = 0; i < lanes; ++i) {
        const float cosine = cosine_density(c, i);
        const glm::vec3 value = e.prefiltered.at(i) * (cosine * by_densities(cosine, p.light.at(i)));
        e.irradiance.set(i, e.irradiance.at(i) + value * (share * raster::kPi));
        sums.x.set(i, sums.x.at(i) + luminance(value));
    }
}

/// ao F_ms f_ms L (n.l)
KREDA_BATCH_LOOP void add_bounced_sample(int lanes, float share, const CookTorranceSetup& setup,
                                         const SampleDensities& p, LightingChannels& c, SampleSums& sums) {
    const MicrofacetChannels& m = c.microfacet;
    EnvironmentChannels& e = c.environment;
    for (int i = 0; i < lanes; ++i) {  // not vectorized: an option of the reference, and most of it are look-ups
        const float n_dot_l = m.n_dot_l.at(i);
        const glm::vec3 f_ms =
            n_dot_l > 0.0f ? compensation_term(setup, m.surface.each(i), n_dot_l, m.n_dot_v.at(i)) : glm::vec3(0.0f);
        const float weight = by_densities(n_dot_l * raster::kInvPi, p.light.at(i)) * m.ao.at(i);
        const glm::vec3 value = f_ms * e.prefiltered.at(i) * weight;
        e.specular.set(i, e.specular.at(i) + value * share);
        sums.x.set(i, sums.x.at(i) + luminance(value));
    }
}

KREDA_BATCH_LOOP void start_error(int lanes, EnvironmentChannels& e) {
    for (int i = 0; i < lanes; ++i) e.error.set(i, 0.0f);  // not vectorized: GCC makes it a call of memset
}

KREDA_BATCH_LOOP void start_way(int lanes, SampleSums& sums) {
    for (int i = 0; i < lanes; ++i) {  // not vectorized: GCC makes it calls of memset
        sums.x.set(i, 0.0f);
        sums.sum.set(i, 0.0f);
        sums.square.set(i, 0.0f);
    }
}

KREDA_BATCH_LOOP void end_sample(int lanes, SampleSums& sums) {
    for (int i = 0; i < lanes; ++i) {
        const float x = sums.x.at(i);
        sums.sum.set(i, sums.sum.at(i) + x);
        sums.square.set(i, sums.square.at(i) + x * x);
        sums.x.set(i, 0.0f);
    }
}

/// The variance of a mean of N:   (sum x^2 - (sum x)^2 / N) / (N (N - 1)),   added to the other ways'.
KREDA_BATCH_LOOP void end_way(int lanes, int samples, const SampleSums& sums, EnvironmentChannels& e) {
    const float N = static_cast<float>(samples);
    const float share = 1.0f / (N * (N > 1.0f ? N - 1.0f : 1.0f));
    for (int i = 0; i < lanes; ++i) {
        const float spread = sums.square.at(i) - sums.sum.at(i) * sums.sum.at(i) / N;
        e.error.set(i, e.error.at(i) + (spread > 0.0f ? spread : 0.0f) * share);
    }
}

KREDA_BATCH_LOOP void end_error(int lanes, EnvironmentChannels& e) {
    for (int i = 0; i < lanes; ++i) e.error.set(i, std::sqrt(e.error.at(i)));
}

/// All samples of one way of choosing.  choose(u): directions into c.l;  add(): what they are worth into the sums.
template <class Choose, class Add>
void sample_one_way(int count, const EnvironmentSetup& setup, EnvironmentChannels& e, SampleSums& sums, Choose choose,
                    Add add) {
    const int lanes = lanes_for(count);
    start_way(lanes, sums);
    for (int k = 0; k < setup.reference_samples; ++k) {
        choose(hammersley(k, setup.reference_samples));
        add();
        end_sample(lanes, sums);
    }
    end_way(lanes, setup.reference_samples, sums, e);
}

}  // namespace

void sum_environment(int count, const CookTorranceSetup& surface, const EnvironmentSetup& setup, LightingChannels& c) {
    const int lanes = lanes_for(count);
    const float share = 1.0f / static_cast<float>(setup.reference_samples);
    const bool bounces = surface.energy_compensation == EnergyCompensation::kulla_conty;
    SampleDensities p;
    SampleSums sums;
    c.l.is_even = false;
    fill_surface(count, c.microfacet.surface);
    start_reference(lanes, c.environment);
    start_error(lanes, c.environment);
    const auto look = [&] {
        evaluate_microfacets(count, surface, LitBy::image, c);
        look_along(count, setup, c, p);
    };
    const auto add_highlight = [&] {
        set_facet_density(lanes, c.microfacet, p.facet);
        add_specular_sample(lanes, share, p, c, sums);
    };
    const auto add_diffuse = [&] {
        add_diffuse_sample(lanes, share, p, c, sums);
        if (bounces) add_bounced_sample(lanes, share, surface, p, c, sums);
    };
    const auto by_facet = [&](const glm::vec2& u) { choose_mirrored(lanes, u, c); };
    const auto by_cosine = [&](const glm::vec2& u) { choose_by_cosine(lanes, u, c); };
    const auto by_light = [&](const glm::vec2& u) {
        choose_light_direction(lanes, setup, choose_light(setup.maps->light, u), c);
    };
    sample_one_way(count, setup, c.environment, sums, by_facet, [&] { look(), add_highlight(); });
    sample_one_way(count, setup, c.environment, sums, by_cosine, [&] { look(), add_diffuse(); });
    sample_one_way(count, setup, c.environment, sums, by_light, [&] { look(), add_highlight(), add_diffuse(); });
    end_error(lanes, c.environment);
}

KREDA_BATCH_LOOP void start_irradiance(int lanes, EnvironmentChannels& e) {
    for (int i = 0; i < lanes; ++i) {  // not vectorized: GCC makes it calls of memset
        e.irradiance.set(i, glm::vec3(0.0f));
    }
}

void sum_irradiance(int count, const EnvironmentSetup& setup, LightingChannels& c) {
    const int lanes = lanes_for(count);
    const float share = 1.0f / static_cast<float>(setup.reference_samples);
    SampleDensities p;
    SampleSums sums;
    c.l.is_even = false;
    start_irradiance(lanes, c.environment);
    start_error(lanes, c.environment);
    const auto add = [&] {
        look_along(count, setup, c, p);
        add_irradiance_sample(lanes, share, p, c, sums);
    };
    sample_one_way(
        count, setup, c.environment, sums, [&](const glm::vec2& u) { choose_by_cosine(lanes, u, c); }, add);
    sample_one_way(
        count, setup, c.environment, sums,
        [&](const glm::vec2& u) { choose_light_direction(lanes, setup, choose_light(setup.maps->light, u), c); }, add);
    end_error(lanes, c.environment);
}

}  // namespace kreda::lighting
