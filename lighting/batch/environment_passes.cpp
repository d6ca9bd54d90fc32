#include "lighting/batch/environment_passes.hpp"

#include "lighting/batch/environment_reference.hpp"
#include "lighting/batch/microfacet_passes.hpp"
#include "lighting/batch/passes.hpp"
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
        e.direction.set(i, mirror_vector(c.n.at(i), c.v.at(i), cosine));
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
KREDA_BATCH_LOOP void add_bounces(int lanes, glm::vec3 f_avg_shift, LightingChannels& c) {
    const MicrofacetChannels& m = c.microfacet;
    EnvironmentChannels& e = c.environment;
    for (int i = 0; i < lanes; ++i) {
        const glm::vec3 brdf = e.brdf.at(i);
        const glm::vec3 F_ms = multiple_scattering_color(m.f0.at(i), f_avg_shift, brdf.z);
        const float lost = raster::saturate(1.0f - (brdf.x + brdf.y));
        const glm::vec3 bounced = F_ms * e.irradiance.at(i) * (lost * raster::kInvPi * m.ao.at(i));
        e.specular.set(i, e.specular.at(i) + bounced);
    }
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
    turn_to_maps(lanes, setup, c.n, e);
    if (setup.maps->sh9)
        irradiance_of_sh9(*setup.maps->sh9, lanes, e.map_direction, e.irradiance);
    else
        sample_level(setup.maps->irradiance, 0, lanes, e.map_direction, e.scratch, e.irradiance);
    scale_channel(lanes, setup.intensity, e.irradiance);
}

/// P along channels.environment.map_direction; without a map of the roughness one level serves all points.
void set_prefiltered(int lanes, const MaterialSetup& material, const EnvironmentSetup& setup, EnvironmentChannels& e) {
    const CubeMap& map = setup.maps->prefiltered;
    if (material.maps.roughness.texture) {
        sample_trilinear(map, lanes, e.map_direction, e.lod, e.scratch, e.prefiltered);
    } else {
        const float lod = level_of_alpha(material.cook_torrance.surface.alpha);
        sample_trilinear(map, lanes, e.map_direction, lod, e.scratch, e.prefiltered);
    }
    scale_channel(lanes, setup.intensity, e.prefiltered);
}

void set_split_sum(int count, const MaterialSetup& material, const EnvironmentSetup& setup, LightingChannels& c) {
    const int lanes = lanes_for(count);
    const CookTorranceSetup& surface = material.cook_torrance;
    EnvironmentChannels& e = c.environment;
    set_irradiance(lanes, setup, c);
    direct_to_mirror(lanes, c);
    turn_to_maps(lanes, setup, e.direction, e);
    set_prefiltered(lanes, material, setup, e);
    const BrdfMap* map = find_brdf(*setup.maps, {surface.distribution, surface.geometry});
    KREDA_EXPECT(map != nullptr);
    look_up_brdf(*map, lanes, c.microfacet.n_dot_v, c.microfacet.roughness, e.scratch, e.brdf);
    evaluate_fresnel(count, surface, c.microfacet);
    split_sum(lanes, c);
    if (surface.energy_compensation == EnergyCompensation::kulla_conty) add_bounces(lanes, surface.f_avg_shift, c);
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
                sum_environment(count, material.cook_torrance, setup, channels);
            else
                set_split_sum(count, material, setup, channels);
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
