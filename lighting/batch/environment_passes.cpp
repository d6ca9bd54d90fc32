#include "lighting/batch/environment_passes.hpp"

#include "lighting/batch/environment_reference.hpp"
#include "lighting/batch/microfacet_passes.hpp"
#include "lighting/batch/passes.hpp"
#include "raster/platform.hpp"

namespace kreda::lighting {

namespace {

using raster::lanes_for;

KREDA_BATCH_LOOP void turn(int lanes, const EnvironmentSetup& setup, const raster::Channel3& direction,
                           EnvironmentChannels& e) {
    const float cos_rotation = setup.cos_rotation;
    const float sin_rotation = setup.sin_rotation;
    for (int i = 0; i < lanes; ++i) {
        e.map_direction.set(i, map_direction(direction.at(i), cos_rotation, sin_rotation));
    }
}

/// The directions as the maps know them: themselves where the environment is not turned.
const raster::Channel3& turned_to_maps(int lanes, const EnvironmentSetup& setup, const raster::Channel3& direction,
                                       EnvironmentChannels& e) {
    if (setup.cos_rotation == 1.0f && setup.sin_rotation == 0.0f) return direction;
    turn(lanes, setup, direction, e);
    return e.map_direction;
}

KREDA_BATCH_LOOP void scale_channel(int lanes, float factor, raster::Channel3& channel) {
    for (int i = 0; i < lanes; ++i) channel.set(i, factor * channel.at(i));
}

void apply_intensity(int lanes, float intensity, raster::Channel3& channel) {
    if (intensity != 1.0f) scale_channel(lanes, intensity, channel);
}

/// r = 2 (n.v) n - v, and what F needs: v.h, for r is n.v.
KREDA_BATCH_LOOP void direct_to_mirror(int lanes, LightingChannels& c) {
    MicrofacetChannels& m = c.microfacet;
    EnvironmentChannels& e = c.environment;
    for (int i = 0; i < lanes; ++i) {
        const float cosine = glm::dot(c.n.at(i), c.v.at(i));
        e.direction.set(i, mirror_vector(c.n.at(i), c.v.at(i), cosine));
        m.v_dot_h.set(i, raster::saturate(cosine));
    }
}

/// The level of the prefiltered map where a map gives the roughness.
KREDA_BATCH_LOOP void set_levels(int lanes, const SurfaceChannels& surface, raster::Channel& level) {
    for (int i = 0; i < lanes; ++i) level.set(i, level_of_alpha(surface.alpha.at(i)));
}

/// ao of a material without a map of it; lamps do not ask for it.
KREDA_BATCH_LOOP void fill_ao(int lanes, float ao, MicrofacetChannels& m) {
    for (int i = 0; i < lanes; ++i) m.ao.set(i, ao);
}

/// May what the split sum adds go to ambient at once? Nobody looks at it, and nothing follows.
bool goes_to_ambient(const CookTorranceSetup& material, LeaveChannels leave, const LightingChannels& c) {
    return leave != LeaveChannels::always && material.energy_compensation == EnergyCompensation::none &&
           c.ambient.is_even;
}

/// add(i, F, diffuse, specular) for every point by `loop`: what the environment adds at point i goes to channels of its
/// own, or `to_ambient`, which is even so far.
template <class Loop>
inline void with_environment_adder(LightingChannels& c, bool to_ambient, Loop loop) {
    EnvironmentChannels& e = c.environment;
    if (to_ambient) {
        c.ambient.is_even = false;
        return loop(
            [&c, ambient = c.ambient.even](int i, glm::vec3, const glm::vec3& diffuse, const glm::vec3& specular) {
                c.ambient.each.set(i, ambient + diffuse + specular);
            });
    }
    loop([&e](int i, const glm::vec3& F, const glm::vec3& diffuse, const glm::vec3& specular) {
        e.F.set(i, F);
        e.diffuse.set(i, diffuse);
        e.specular.set(i, specular);
    });
}

KREDA_BATCH_LOOP void split_sum(int lanes, bool to_ambient, LightingChannels& c) {
    const MicrofacetChannels& m = c.microfacet;
    const EnvironmentChannels& e = c.environment;
    with_environment_adder(c, to_ambient, [&](auto add) {
        with_surface(m.surface, [&](auto surface) {
            for (int i = 0; i < lanes; ++i) {  // 4 formulas
                const glm::vec3 F = m.F.at(i);
                const glm::vec3 brdf = e.brdf.at(i);
                const glm::vec3 k_d = diffuse_share(F, surface(i).metallic);
                const float ao = m.ao.at(i);
                add(i, F, k_d * surface(i).albedo * e.irradiance.at(i) * (raster::kInvPi * ao),
                    e.prefiltered.at(i) * (surface(i).f0 * brdf.x + glm::vec3(brdf.y)) * ao);
            }
        });
    });
}

/// What bounces between facets before it leaves: Kulla and Conty's lobe under light from all sides
///   F_ms (1 - (A + B)) E / pi,   since the integral of (1 - E(n.l)) (n.l) / (pi (1 - E_avg)) is 1
KREDA_BATCH_LOOP void add_bounces(int lanes, glm::vec3 f_avg_shift, LightingChannels& c) {
    const MicrofacetChannels& m = c.microfacet;
    EnvironmentChannels& e = c.environment;
    with_surface(m.surface, [&](auto surface) {
        for (int i = 0; i < lanes; ++i) {  // 2 formulas
            const glm::vec3 brdf = e.brdf.at(i);
            const glm::vec3 F_ms = multiple_scattering_color(surface(i).f0, f_avg_shift, brdf.z);
            const float lost = raster::saturate(1.0f - (brdf.x + brdf.y));
            const glm::vec3 bounced = F_ms * e.irradiance.at(i) * (lost * raster::kInvPi * m.ao.at(i));
            e.specular.set(i, e.specular.at(i) + bounced);
        }
    });
}

KREDA_BATCH_LOOP void reflect_diffusely(int lanes, glm::vec3 m_D, LightingChannels& c) {
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
    with_quantity(c.ambient, [&](auto ambient) {
        for (int i = 0; i < lanes; ++i) {  // 2 formulas
            c.ambient.each.set(i, ambient(i) + e.diffuse.at(i) + e.specular.at(i));
        }
    });
    c.ambient.is_even = false;
}

/// E; 0 where it is not baked: metals alone reflect nothing diffusely.
void set_irradiance(int lanes, const EnvironmentSetup& setup, LightingChannels& c) {
    EnvironmentChannels& e = c.environment;
    if (!setup.maps->sh9 && setup.maps->irradiance.empty()) return start_irradiance(lanes, e);
    const raster::Channel3& n = turned_to_maps(lanes, setup, c.n, e);
    if (setup.maps->sh9)
        irradiance_of_sh9(*setup.maps->sh9, lanes, n, e.irradiance);
    else
        sample_level(setup.maps->irradiance, 0, lanes, n, e.scratch, e.irradiance);
    apply_intensity(lanes, setup.intensity, e.irradiance);
}

/// P along channels.environment.direction; where the roughness is the same everywhere one level serves all points.
void set_prefiltered(int lanes, const EnvironmentSetup& setup, const SurfaceChannels& surface, EnvironmentChannels& e) {
    const CubeMap& map = setup.maps->prefiltered;
    const raster::Channel3& r = turned_to_maps(lanes, setup, e.direction, e);
    if (surface.is_even) {
        sample_trilinear(map, lanes, r, level_of_alpha(surface.even.alpha), e.scratch, e.prefiltered);
    } else {
        set_levels(lanes, surface, e.lod);
        sample_trilinear(map, lanes, r, e.lod, e.scratch, e.prefiltered);
    }
    apply_intensity(lanes, setup.intensity, e.prefiltered);
}

void set_split_sum(int count, const CookTorranceSetup& material, const EnvironmentSetup& setup, bool to_ambient,
                   LightingChannels& c) {
    const int lanes = lanes_for(count);
    const SurfaceChannels& surface = c.microfacet.surface;
    EnvironmentChannels& e = c.environment;
    set_irradiance(lanes, setup, c);
    direct_to_mirror(lanes, c);
    set_prefiltered(lanes, setup, surface, e);
    const BrdfMap* map = find_brdf(*setup.maps, {material.distribution, material.geometry});
    KREDA_EXPECT(map != nullptr);
    if (surface.is_even)
        look_up_brdf(*map, lanes, c.microfacet.n_dot_v, surface.even.roughness, e.scratch, e.brdf);
    else
        look_up_brdf(*map, lanes, c.microfacet.n_dot_v, surface.roughness, e.scratch, e.brdf);
    evaluate_fresnel(count, material, c.microfacet);
    split_sum(lanes, to_ambient, c);
    if (material.energy_compensation == EnergyCompensation::kulla_conty) add_bounces(lanes, material.f_avg_shift, c);
}

}  // namespace

const raster::Channel3& look_at_environment(int count, const EnvironmentSetup& setup, const raster::Channel3& direction,
                                            EnvironmentChannels& channels) {
    const int lanes = lanes_for(count);
    const raster::Channel3& on_map = turned_to_maps(lanes, setup, direction, channels);
    sample_level(setup.maps->prefiltered, 0, lanes, on_map, channels.scratch, channels.prefiltered);
    apply_intensity(lanes, setup.intensity, channels.prefiltered);
    return on_map;
}

void add_environment(const raster::Fragments& fragments, const MaterialSetup& material, const EnvironmentSetup& setup,
                     LeaveChannels leave, LightingChannels& channels) {
    const int count = fragments.count;
    const int lanes = lanes_for(count);
    const bool exact = setup.reference_samples > 0;
    switch (material.material.model) {
        case ReflectionModel::unlit: return;
        case ReflectionModel::cook_torrance:
            if (!material.maps.ao.texture) fill_ao(lanes, material.material.cook_torrance.ao, channels.microfacet);
            if (!exact) {
                const bool to_ambient = goes_to_ambient(material.cook_torrance, leave, channels);
                set_split_sum(count, material.cook_torrance, setup, to_ambient, channels);
                if (to_ambient) return;
            } else {
                sum_environment(count, material.cook_torrance, setup, channels);
            }
            break;
        default:
            if (exact)
                sum_irradiance(count, setup, channels);
            else
                set_irradiance(lanes, setup, channels);
            if (material.maps.diffuse.texture)
                reflect_diffusely_from_map(lanes, channels);
            else
                reflect_diffusely(lanes, material.material.phong.diffuse, channels);
    }
    add_to_ambient(lanes, channels);
}

}  // namespace kreda::lighting
