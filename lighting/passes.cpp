#include "lighting/passes.hpp"

#include "lighting/microfacet_passes.hpp"
#include "lighting/model_loop.hpp"
#include "lighting/reflection.hpp"
#include "lighting/ward_passes.hpp"
#include "raster/platform.hpp"

namespace kreda::lighting {

namespace {

using raster::Channel3;
using raster::Fragments;
using raster::lanes_for;

/// n = normal / |normal|,  v = (eye - p) / |eye - p|  (perspective) or the same everywhere (orthographic).
KREDA_BATCH_LOOP void surface_directions(const Fragments& f, int lanes, const LightingSetup& setup,
                                         LightingChannels& c) {
    const glm::vec3 eye = setup.eye;
    for (int i = 0; i < lanes; ++i) {
        c.n.set(i, unit(f.normal.at(i)));
        c.v.set(i, unit(eye - f.position.at(i)));
    }
}

KREDA_BATCH_LOOP void same_view_everywhere(int lanes, const glm::vec3& to_viewer, LightingChannels& c) {
    const glm::vec3 v = to_viewer;
    for (int i = 0; i < lanes; ++i) c.v.set(i, v);
}

/// What is there without any light: s_A m_A + m_E, and nothing reflected yet.
KREDA_BATCH_LOOP void start_terms(int lanes, const glm::vec3& ambient_and_emission, LightingChannels& c) {
    const glm::vec3 base = ambient_and_emission;
    for (int i = 0; i < lanes; ++i) {
        c.ambient.set(i, base);
        c.diffuse.set(i, glm::vec3(0.0f));
        c.specular.set(i, glm::vec3(0.0f));
    }
}

/// Unlit: what the map shows, and m_E.
KREDA_BATCH_LOOP void shine_by_map(int lanes, const glm::vec3& emission, LightingChannels& c) {
    const glm::vec3 m_E = emission;
    for (int i = 0; i < lanes; ++i) c.ambient.set(i, c.m_D.at(i) + m_E);
}

KREDA_BATCH_LOOP void sample_directional_light(int lanes, const LightSetup& setup, LightingChannels& c) {
    const LightSetup light = setup;
    for (int i = 0; i < lanes; ++i) {
        const LightSample s = sample_directional(light);
        c.l.set(i, s.l);
        c.irradiance.set(i, s.irradiance);
    }
}

KREDA_BATCH_LOOP void sample_point_light(const Fragments& f, int lanes, const LightSetup& setup, LightingChannels& c) {
    const LightSetup light = setup;
    for (int i = 0; i < lanes; ++i) {
        const LightSample s = sample_point(light, f.position.at(i));
        c.l.set(i, s.l);
        c.irradiance.set(i, s.irradiance);
    }
}

KREDA_BATCH_LOOP void sample_spot_light(const Fragments& f, int lanes, const LightSetup& setup, LightingChannels& c) {
    const LightSetup light = setup;
    for (int i = 0; i < lanes; ++i) {
        const LightSample s = sample_spot(light, f.position.at(i));
        c.l.set(i, s.l);
        c.irradiance.set(i, s.irradiance);
    }
}

KREDA_BATCH_LOOP void add_lambert(int lanes, const PhongMaterial& material, bool map, LightingChannels& c) {
    add_model(lanes, material, map, c, [&c](int i, const PhongMaterial& m) {
        return lambert(c.n.at(i), c.l.at(i), m);
    });
}

KREDA_BATCH_LOOP void add_phong(int lanes, const PhongMaterial& material, bool map, LightingChannels& c) {
    add_model(lanes, material, map, c, [&c](int i, const PhongMaterial& m) {
        return phong(c.n.at(i), c.l.at(i), c.v.at(i), m);
    });
}

KREDA_BATCH_LOOP void add_blinn_phong(int lanes, const PhongMaterial& material, bool map, LightingChannels& c) {
    add_model(lanes, material, map, c, [&c](int i, const PhongMaterial& m) {
        return blinn_phong(c.n.at(i), c.l.at(i), c.v.at(i), m);
    });
}

KREDA_BATCH_LOOP void shadow_irradiance(int lanes, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) c.irradiance.set(i, c.shadow.at(i) * c.irradiance.at(i));
}

KREDA_BATCH_LOOP void add_up(int lanes, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) c.radiance.set(i, c.ambient.at(i) + c.diffuse.at(i) + c.specular.at(i));
}

/// What a surface shows without any light: s_A m_A + m_E; the microfacet model knows no ambient light.
glm::vec3 unlit_radiance(const Material& material, const glm::vec3& s_A) {
    const PhongMaterial& m = material.phong;
    switch (material.model) {
        case ReflectionModel::unlit: return m.diffuse + m.emission;
        case ReflectionModel::cook_torrance: return m.emission;
        default: return ambient_term(s_A, m.ambient) + m.emission;
    }
}

template <class FogFormula>
inline void fog_loop(const Fragments& f, int lanes, const LightingSetup& setup, LightingChannels& c,
                     FogFormula formula) {
    const glm::vec3 eye = setup.eye;
    const glm::vec3 forward = setup.forward;
    const bool planar = setup.fog.distance == FogDistance::planar;
    for (int i = 0; i < lanes; ++i) {
        const glm::vec3 p = f.position.at(i);
        const float plane_z = planar_distance(p, eye, forward);
        const float ray_z = radial_distance(p, eye);
        c.fog.set(i, formula(planar ? plane_z : ray_z));
    }
}

KREDA_BATCH_LOOP void linear_fog(const Fragments& f, int lanes, const LightingSetup& setup, LightingChannels& c) {
    const float start = setup.fog.start;
    const float end = setup.fog.end;
    fog_loop(f, lanes, setup, c, [=](float z) { return fog_linear(z, start, end); });
}

KREDA_BATCH_LOOP void exp_fog(const Fragments& f, int lanes, const LightingSetup& setup, LightingChannels& c) {
    const float density = setup.fog.density;
    fog_loop(f, lanes, setup, c, [=](float z) { return fog_exp(z, density); });
}

KREDA_BATCH_LOOP void exp2_fog(const Fragments& f, int lanes, const LightingSetup& setup, LightingChannels& c) {
    const float density = setup.fog.density;
    fog_loop(f, lanes, setup, c, [=](float z) { return fog_exp2(z, density); });
}

KREDA_BATCH_LOOP void mix_with_fog(int lanes, const glm::vec3& fog_color, LightingChannels& c) {
    const glm::vec3 c_f = fog_color;
    for (int i = 0; i < lanes; ++i) c.radiance.set(i, mix_fog(c.fog.at(i), c.radiance.at(i), c_f));
}

}  // namespace

MaterialSetup prepare(const Material& material) {
    MaterialSetup setup;
    setup.material = material;
    if (material.model == ReflectionModel::cook_torrance) setup.cook_torrance = prepare(material.cook_torrance);
    setup.maps = maps_in_use(material);
    setup.map_needs = needs_of(setup.maps);
    return setup;
}

void start_lighting(const Fragments& fragments, const MaterialSetup& material, const LightingSetup& setup,
                    LightingChannels& channels) {
    const int lanes = lanes_for(fragments.count);
    const ReflectionModel model = material.material.model;
    start_terms(lanes, unlit_radiance(material.material, setup.ambient), channels);
    if (model == ReflectionModel::cook_torrance) {
        fill_surface(fragments.count, material.cook_torrance, channels.microfacet);
    }
    if (material.map_needs.uv) read_maps(fragments, material.maps, material.cook_torrance, channels);
    if (model == ReflectionModel::unlit) {
        if (material.maps.diffuse.texture) shine_by_map(lanes, material.material.phong.emission, channels);
        return;
    }
    surface_directions(fragments, lanes, setup, channels);
    if (setup.orthographic) same_view_everywhere(lanes, -setup.forward, channels);
    if (material.map_needs.tangent) bend_normals(fragments, material.maps, channels);
    if (needs_grain(material.material)) find_grain(fragments.count, material.material.phong, channels);
}

void sample_light(const Fragments& fragments, const LightSetup& light, LightingChannels& channels) {
    const int lanes = lanes_for(fragments.count);
    switch (light.type) {
        case LightType::directional: return sample_directional_light(lanes, light, channels);
        case LightType::point: return sample_point_light(fragments, lanes, light, channels);
        case LightType::spot: return sample_spot_light(fragments, lanes, light, channels);
    }
}

void shadow_light(int count, LightingChannels& channels) {
    shadow_irradiance(lanes_for(count), channels);
}

void add_reflection(int count, const MaterialSetup& setup, LightingChannels& c) {
    const int lanes = lanes_for(count);
    const PhongMaterial& m = setup.material.phong;
    const bool map = setup.maps.diffuse.texture != nullptr;
    switch (setup.material.model) {
        case ReflectionModel::unlit: return;
        case ReflectionModel::lambert: return add_lambert(lanes, m, map, c);
        case ReflectionModel::phong: return add_phong(lanes, m, map, c);
        case ReflectionModel::blinn_phong: return add_blinn_phong(lanes, m, map, c);
        case ReflectionModel::ward: return add_ward(count, m, map, c);
        case ReflectionModel::heidrich_seidel: return add_heidrich_seidel(count, m, map, c);
        case ReflectionModel::cook_torrance: return add_cook_torrance(count, setup.cook_torrance, c);
    }
}

void sum_terms(int count, LightingChannels& channels) {
    add_up(lanes_for(count), channels);
}

void copy_color(const Fragments& fragments, LightingChannels& channels) {
    const int lanes = lanes_for(fragments.count);
    for (int i = 0; i < lanes; ++i) {  // not vectorized: GCC makes it calls of memcpy
        channels.radiance.set(i, fragments.color.at(i));
    }
}

void fog_factors(const Fragments& fragments, const LightingSetup& setup, LightingChannels& channels) {
    const int lanes = lanes_for(fragments.count);
    switch (setup.fog.mode) {
        case FogMode::none: return;
        case FogMode::linear: return linear_fog(fragments, lanes, setup, channels);
        case FogMode::exp: return exp_fog(fragments, lanes, setup, channels);
        case FogMode::exp2: return exp2_fog(fragments, lanes, setup, channels);
    }
}

void copy_fog(const Fragments& fragments, LightingChannels& channels) {
    for (int i = 0; i < fragments.count; ++i) channels.fog.set(i, fragments.fog.at(i));
}

void apply_fog(int count, const glm::vec3& fog_color, LightingChannels& channels) {
    mix_with_fog(lanes_for(count), fog_color, channels);
}

}  // namespace kreda::lighting
