#include "lighting/batch/environment_passes.hpp"

#include "lighting/batch/microfacet_passes.hpp"
#include "lighting/batch/passes.hpp"
#include "lighting/environment/light_table.hpp"
#include "lighting/importance.hpp"
#include "raster/platform.hpp"

namespace kreda::lighting {

namespace {

using raster::lanes_for;

KREDA_BATCH_LOOP void turn_to_maps(int lanes, const EnvironmentSetup& setup, const raster::Channel3& direction,
                                   EnvironmentChannels& e) {
    const float cos_rotation = setup.cos_rotation;
    const float sin_rotation = setup.sin_rotation;
    for (int i = 0; i < lanes; ++i) {
        e.map_direction.set(i, map_direction(direction.at(i), cos_rotation, sin_rotation));
    }
}

KREDA_BATCH_LOOP void scale_channel(int lanes, float factor, raster::Channel3& channel) {
    for (int i = 0; i < lanes; ++i) channel.set(i, factor * channel.at(i));
}

/// r = 2 (n.v) n - v, and what the look-ups and F need: v.h, for r is n.v, and the level of this roughness.
KREDA_BATCH_LOOP void direct_to_mirror(int lanes, LightingChannels& c) {
    MicrofacetChannels& m = c.microfacet;
    EnvironmentChannels& e = c.environment;
    for (int i = 0; i < lanes; ++i) {
        const float cosine = glm::dot(c.n.at(i), c.v.at(i));
        e.direction.set(i, (2.0f * cosine) * c.n.at(i) - c.v.at(i));
        e.lod.set(i, level_of_alpha(m.alpha.at(i)));
        m.v_dot_h.set(i, raster::saturate(cosine));
    }
}

/// ao of a material without a map of it; lamps do not ask for it.
KREDA_BATCH_LOOP void fill_ao(int lanes, float ao, MicrofacetChannels& m) {
    for (int i = 0; i < lanes; ++i) m.ao.set(i, ao);
}

KREDA_BATCH_LOOP void split_sum(int lanes, LightingChannels& c) {
    const MicrofacetChannels& m = c.microfacet;
    EnvironmentChannels& e = c.environment;
    for (int i = 0; i < lanes; ++i) {
        const glm::vec3 F = m.F.at(i);
        const glm::vec3 brdf = e.brdf.at(i);
        const glm::vec3 k_d = diffuse_share(F, m.metallic.at(i));
        const float ao = m.ao.at(i);
        e.F.set(i, F);
        e.diffuse.set(i, k_d * m.albedo.at(i) * e.irradiance.at(i) * (raster::kInvPi * ao));
        e.specular.set(i, e.prefiltered.at(i) * (m.f0.at(i) * brdf.x + glm::vec3(brdf.y)) * ao);
    }
}

/// What bounces between facets before it leaves: Kulla and Conty's lobe under light from all sides
///   F_ms (1 - (A + B)) E / pi,   since the integral of (1 - E(n.l)) (n.l) / (pi (1 - E_avg)) is 1
KREDA_BATCH_LOOP void add_bounces(int lanes, const CookTorranceSetup& setup, LightingChannels& c) {
    const glm::vec3 shift = setup.f_avg_shift;
    const MicrofacetChannels& m = c.microfacet;
    EnvironmentChannels& e = c.environment;
    for (int i = 0; i < lanes; ++i) {
        const glm::vec3 brdf = e.brdf.at(i);
        const glm::vec3 f0 = m.f0.at(i);
        const glm::vec3 F_ms{multiple_scattering_color(average_schlick(f0.x) + shift.x, brdf.z),
                             multiple_scattering_color(average_schlick(f0.y) + shift.y, brdf.z),
                             multiple_scattering_color(average_schlick(f0.z) + shift.z, brdf.z)};
        const float lost = raster::saturate(1.0f - (brdf.x + brdf.y));
        const glm::vec3 bounced = F_ms * e.irradiance.at(i) * (lost * raster::kInvPi * m.ao.at(i));
        e.specular.set(i, e.specular.at(i) + bounced);
    }
}

KREDA_BATCH_LOOP void reflect_diffusely(int lanes, const glm::vec3& diffuse, LightingChannels& c) {
    const glm::vec3 m_D = diffuse;
    EnvironmentChannels& e = c.environment;
    for (int i = 0; i < lanes; ++i) {
        e.diffuse.set(i, m_D * e.irradiance.at(i) * raster::kInvPi);
        e.specular.set(i, glm::vec3(0.0f));
    }
}

KREDA_BATCH_LOOP void reflect_diffusely_from_map(int lanes, LightingChannels& c) {
    EnvironmentChannels& e = c.environment;
    for (int i = 0; i < lanes; ++i) {
        e.diffuse.set(i, c.m_D.at(i) * e.irradiance.at(i) * raster::kInvPi);
        e.specular.set(i, glm::vec3(0.0f));
    }
}

KREDA_BATCH_LOOP void add_to_ambient(int lanes, LightingChannels& c) {
    const EnvironmentChannels& e = c.environment;
    for (int i = 0; i < lanes; ++i) c.ambient.set(i, c.ambient.at(i) + e.diffuse.at(i) + e.specular.at(i));
}

KREDA_BATCH_LOOP void start_irradiance(int lanes, EnvironmentChannels& e) {
    for (int i = 0; i < lanes; ++i) {  // not vectorized: GCC makes it calls of memset
        e.irradiance.set(i, glm::vec3(0.0f));
    }
}

/// E; 0 where it is not baked: metals alone reflect nothing diffusely.
void find_irradiance(int lanes, const EnvironmentSetup& setup, LightingChannels& c) {
    EnvironmentChannels& e = c.environment;
    if (!setup.maps->sh9 && setup.maps->irradiance.empty()) return start_irradiance(lanes, e);
    turn_to_maps(lanes, setup, c.n, e);
    if (setup.maps->sh9)
        irradiance_of_sh9(*setup.maps->sh9, lanes, e.map_direction, e.irradiance);
    else
        sample_level(setup.maps->irradiance, 0, lanes, e.map_direction, e.scratch, e.irradiance);
    scale_channel(lanes, setup.intensity, e.irradiance);
}

/// P along channels.environment.map_direction; without a map of the roughness one level serves all points.
void find_prefiltered(int lanes, const MaterialSetup& material, const EnvironmentSetup& setup, EnvironmentChannels& e) {
    const CubeMap& map = setup.maps->prefiltered;
    if (material.maps.roughness.texture) {
        sample_trilinear(map, lanes, e.map_direction, e.lod, e.scratch, e.prefiltered);
    } else {
        const float lod = level_of_alpha(material.cook_torrance.surface.alpha);
        sample_trilinear(map, lanes, e.map_direction, lod, e.scratch, e.prefiltered);
    }
    scale_channel(lanes, setup.intensity, e.prefiltered);
}

void find_split_sum(int count, const MaterialSetup& material, const EnvironmentSetup& setup, LightingChannels& c) {
    const int lanes = lanes_for(count);
    const CookTorranceSetup& surface = material.cook_torrance;
    EnvironmentChannels& e = c.environment;
    find_irradiance(lanes, setup, c);
    direct_to_mirror(lanes, c);
    turn_to_maps(lanes, setup, e.direction, e);
    find_prefiltered(lanes, material, setup, e);
    const BrdfMap* map = find_brdf(*setup.maps, {surface.distribution, surface.geometry});
    KREDA_EXPECT(map != nullptr);
    look_up_brdf(*map, lanes, c.microfacet.n_dot_v, c.microfacet.roughness, e.scratch, e.brdf);
    evaluate_fresnel(count, surface, c.microfacet);
    split_sum(lanes, c);
    if (surface.energy_compensation == EnergyCompensation::kulla_conty) add_bounces(lanes, surface, c);
}

// ---------------------------------------------------------------------------------------- the integral itself

KREDA_BATCH_LOOP void start_reference(int lanes, EnvironmentChannels& e) {
    for (int i = 0; i < lanes; ++i) {  // not vectorized: GCC makes it calls of memset
        e.diffuse.set(i, glm::vec3(0.0f));
        e.specular.set(i, glm::vec3(0.0f));
    }
}

/// l of sample u: v mirrored in a facet that v sees.
KREDA_BATCH_LOOP void choose_mirrored(int lanes, const glm::vec2& u, LightingChannels& c) {
    const glm::vec2 point = u;
    for (int i = 0; i < lanes; ++i) {
        const Frame frame = frame_around(c.n.at(i));
        const glm::vec3 v = to_surface(frame, c.v.at(i));
        const glm::vec3 seen{v.x, v.y, v.z > 1e-4f ? v.z : 1e-4f};
        const glm::vec3 l = mirrored(seen, visible_half_vector(point, seen, c.microfacet.alpha.at(i)));
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

KREDA_BATCH_LOOP void find_light_density(int lanes, const LightTable& light_table, const EnvironmentChannels& e,
                                         SampleDensities& p) {
    const int size = light_table.size;
    for (int i = 0; i < lanes; ++i) {
        const DensityTap tap = density_tap(size, e.map_direction.at(i));
        p.texel[i] = tap.texel;
        p.light.set(i, tap.factor);
    }
    const float* density = light_table.density.data();
    for (int i = 0; i < lanes; ++i) p.light.value[i] *= density[p.texel[i]];  // not vectorized: reads here and there
}

/// p = D_GGX G_1(v) / (4 n.v) = D_GGX / (2 (n.v + root))
KREDA_BATCH_LOOP void find_facet_density(int lanes, const MicrofacetChannels& m, raster::Channel& density) {
    for (int i = 0; i < lanes; ++i) {
        const float alpha = m.alpha.at(i), n_dot_v = m.n_dot_v.at(i);
        const float D = ggx_distribution(m.n_dot_h.at(i), m.sin2_h.at(i), alpha);
        density.set(i, D / (2.0f * (n_dot_v + smith_root(n_dot_v, alpha))));
    }
}

/// L along c.l into e.prefiltered, and how likely that direction is to be chosen.
void look_along(int count, const EnvironmentSetup& setup, LightingChannels& c, SampleDensities& p) {
    look_at_environment(count, setup, c.l, c.environment);
    find_light_density(lanes_for(count), setup.maps->light, c.environment, p);
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
        const glm::vec3 k_d = diffuse_share(m.F.at(i), m.metallic.at(i));
        const float cosine = cosine_density(c, i);
        const float weight = cosine * by_densities(cosine, p.light.at(i)) * m.ao.at(i);
        const glm::vec3 value = k_d * m.albedo.at(i) * e.prefiltered.at(i) * weight;
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
        MicrofacetSurface surface;
        surface.f0 = m.f0.at(i);
        surface.roughness = m.roughness.at(i);
        const float n_dot_l = m.n_dot_l.at(i);
        const glm::vec3 f_ms =
            n_dot_l > 0.0f ? compensation_term(setup, surface, n_dot_l, m.n_dot_v.at(i)) : glm::vec3(0.0f);
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

void find_reference(int count, const CookTorranceSetup& surface, const EnvironmentSetup& setup, LightingChannels& c) {
    const int lanes = lanes_for(count);
    const float share = 1.0f / static_cast<float>(setup.reference_samples);
    const bool bounces = surface.energy_compensation == EnergyCompensation::kulla_conty;
    SampleDensities p;
    SampleSums sums;
    start_reference(lanes, c.environment);
    start_error(lanes, c.environment);
    const auto look = [&] {
        evaluate_microfacets(count, surface, LitBy::image, c);
        look_along(count, setup, c, p);
    };
    const auto add_highlight = [&] {
        find_facet_density(lanes, c.microfacet, p.facet);
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

void find_reference_irradiance(int count, const EnvironmentSetup& setup, LightingChannels& c) {
    const int lanes = lanes_for(count);
    const float share = 1.0f / static_cast<float>(setup.reference_samples);
    SampleDensities p;
    SampleSums sums;
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

}  // namespace

void look_at_environment(int count, const EnvironmentSetup& setup, const raster::Channel3& direction,
                         EnvironmentChannels& channels) {
    const int lanes = lanes_for(count);
    turn_to_maps(lanes, setup, direction, channels);
    sample_level(setup.maps->prefiltered, 0, lanes, channels.map_direction, channels.scratch, channels.prefiltered);
    scale_channel(lanes, setup.intensity, channels.prefiltered);
}

void add_environment(const raster::Fragments& fragments, const MaterialSetup& material, const EnvironmentSetup& setup,
                     LightingChannels& channels) {
    const int count = fragments.count;
    const int lanes = lanes_for(count);
    const bool exact = setup.reference_samples > 0;
    switch (material.material.model) {
        case ReflectionModel::unlit: return;
        case ReflectionModel::cook_torrance:
            if (!material.maps.ao.texture) fill_ao(lanes, material.material.cook_torrance.ao, channels.microfacet);
            if (exact)
                find_reference(count, material.cook_torrance, setup, channels);
            else
                find_split_sum(count, material, setup, channels);
            break;
        default:
            if (exact)
                find_reference_irradiance(count, setup, channels);
            else
                find_irradiance(lanes, setup, channels);
            if (material.maps.diffuse.texture)
                reflect_diffusely_from_map(lanes, channels);
            else
                reflect_diffusely(lanes, material.material.phong.diffuse, channels);
    }
    add_to_ambient(lanes, channels);
}

}  // namespace kreda::lighting
