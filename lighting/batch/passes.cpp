#include "lighting/batch/passes.hpp"

#include "lighting/batch/add_light.hpp"
#include "lighting/batch/highlight_passes.hpp"
#include "lighting/batch/microfacet_passes.hpp"
#include "lighting/batch/model_loop.hpp"
#include "lighting/batch/ward_passes.hpp"
#include "lighting/light_sample.hpp"
#include "lighting/reflect.hpp"
#include "lighting/reflection.hpp"
#include "raster/platform.hpp"

namespace kreda::lighting {

namespace {

using raster::Fragments;
using raster::lanes_for;

/// n = normal / |normal|,  v = (eye - p) / |eye - p|  (perspective) or the same everywhere (orthographic).
KREDA_BATCH_LOOP void surface_directions(const Fragments& f, int lanes, glm::vec3 eye, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) {
        c.n.set(i, unit(f.normal.at(i)));
        c.v.set(i, unit(eye - f.position.at(i)));
    }
}

KREDA_BATCH_LOOP void same_view_everywhere(int lanes, glm::vec3 v, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) c.v.set(i, v);
}

/// Nothing reflected.
KREDA_BATCH_LOOP void clear_sums(int lanes, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) {  // not vectorized: GCC makes it calls of memset
        c.diffuse.set(i, glm::vec3(0.0f));
        c.specular.set(i, glm::vec3(0.0f));
    }
}

/// Where a map says how much each point emits: m_E is the map times the constant.
KREDA_BATCH_LOOP void add_emission_of_map(int lanes, glm::vec3 constant, LightingChannels& c) {
    with_quantity(c.ambient, [&](auto ambient) {
        for (int i = 0; i < lanes; ++i) {  // 2 formulas
            c.ambient.each.set(i, ambient(i) + constant * c.map_emission.at(i));
        }
    });
    c.ambient.is_even = false;
}

/// Unlit: what the map shows, and m_E.
KREDA_BATCH_LOOP void shine_by_map(int lanes, glm::vec3 m_E, LightingChannels& c) {
    c.ambient.is_even = false;
    for (int i = 0; i < lanes; ++i) c.ambient.each.set(i, c.m_D.at(i) + m_E);
}

/// What one light sends to point i.
inline void set_light(LightingChannels& c, int i, const LightSample& s) {
    c.irradiance.each.set(i, s.irradiance);
    set_direction_to_light(c, i, s.l);
}

KREDA_BATCH_LOOP void set_n_dot_l(int lanes, glm::vec3 l, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) c.n_dot_l.set(i, glm::dot(c.n.at(i), l));
}

/// l and s are the same at every point: n.l alone is a channel.
void sample_directional_light(int lanes, const LightSetup& light, LightingChannels& c) {
    const LightSample s = sample_directional(light);
    c.l.set_all(s.l);
    c.irradiance.set_all(s.irradiance);
    set_n_dot_l(lanes, s.l, c);
}

KREDA_BATCH_LOOP void sample_point_light(const Fragments& f, int lanes, LightSetup light, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) set_light(c, i, sample_point(light, f.position.at(i)));
}

KREDA_BATCH_LOOP void sample_spot_light(const Fragments& f, int lanes, LightSetup light, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) set_light(c, i, sample_spot(light, f.position.at(i)));
}

/// How many lanes face the light, the ones behind the last point among them.
KREDA_BATCH_LOOP int lanes_facing_light(int lanes, const LightingChannels& c) {
    int facing = 0;
    for (int i = 0; i < lanes; ++i) facing += c.n_dot_l.at(i) > 0.0f ? 1 : 0;
    return facing;
}

KREDA_BATCH_LOOP void add_lambert(int lanes, const PhongMaterial& material, bool map, LightingChannels& c) {
    add_model(lanes, material, map, c,
              [&c](int i, const PhongMaterial& m) { return lambert(c.n.at(i), c.l.at(i), m); });
}

KREDA_BATCH_LOOP void shadow_irradiance(int lanes, LightingChannels& c) {
    with_quantity(c.irradiance, [&](auto s) {
        for (int i = 0; i < lanes; ++i) c.irradiance.each.set(i, c.shadow.at(i) * s(i));  // 2 formulas
    });
    c.irradiance.is_even = false;
}

KREDA_BATCH_LOOP void add_up(int lanes, LightingChannels& c) {
    with_quantity(c.ambient, [&](auto ambient) {
        for (int i = 0; i < lanes; ++i) {  // 2 formulas
            c.radiance.set(i, ambient(i) + c.diffuse.at(i) + c.specular.at(i));
        }
    });
}

/// m_E where it is the same at every point; a map adds its own.
glm::vec3 even_emission(const MaterialSetup& setup) {
    return setup.maps.emission.texture ? glm::vec3(0.0f) : setup.material.phong.emission;
}

/// What a surface shows without any light: s_A m_A + m_E; the microfacet model knows no ambient light.
glm::vec3 own_radiance(const MaterialSetup& setup, const glm::vec3& s_A) {
    const PhongMaterial& m = setup.material.phong;
    const glm::vec3 m_E = even_emission(setup);
    switch (setup.material.model) {
        case ReflectionModel::unlit: return m.diffuse + m_E;
        case ReflectionModel::cook_torrance: return m_E;
        default: return ambient_term(s_A, m.ambient) + m_E;
    }
}

/// What an earlier batch left in the channels of the formula's steps is not this point's.
void forget_steps(LightingChannels& c) {
    MicrofacetChannels& m = c.microfacet;
    for (raster::Channel* step : {&c.sigma, &c.highlight, &m.n_dot_l, &m.n_dot_h, &m.v_dot_h, &m.sin2_h, &m.D, &m.V}) {
        step->set(0, 0.0f);
    }
    m.F.set(0, glm::vec3(0.0f));
}

/// One point: the whole formula.
void add_whole_reflection(const MaterialSetup& material, LightingChannels& c) {
    forget_steps(c);
    const ReflectedTerms terms = reflect(material_at(material, c, 0), c.n.at(0), c.l.at(0), c.v.at(0));
    with_adder(c, [&](auto add) { add(0, terms); });
}

void add_reflection_by_passes(int count, const MaterialSetup& setup, LightingChannels& c) {
    const int lanes = lanes_for(count);
    const PhongMaterial& m = setup.material.phong;
    const bool map = setup.maps.diffuse.texture != nullptr;
    switch (setup.material.model) {
        case ReflectionModel::unlit: return;
        case ReflectionModel::lambert: return add_lambert(lanes, m, map, c);
        case ReflectionModel::phong:
        case ReflectionModel::blinn_phong: return add_highlights(count, setup.material, map, c);
        case ReflectionModel::ward: return add_ward(count, m, map, c);
        case ReflectionModel::heidrich_seidel: return add_heidrich_seidel(count, m, map, c);
        case ReflectionModel::cook_torrance: return add_cook_torrance(count, setup.cook_torrance, c);
    }
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

void start_surface(const MaterialSetup& material, const LightingSetup& setup, LightingChannels& channels) {
    channels.ambient.set_all(own_radiance(material, setup.ambient));
    channels.is_lit = channels.is_summed = false;
    if (material.material.model != ReflectionModel::cook_torrance) return;
    channels.microfacet.surface.set_all(material.cook_torrance.surface);
}

void apply_maps(const Fragments& fragments, const MaterialSetup& material, LightingChannels& channels) {
    read_maps(fragments, material.maps, material.cook_torrance, channels);
    const int lanes = lanes_for(fragments.count);
    const bool shows_map = material.material.model == ReflectionModel::unlit && material.maps.diffuse.texture;
    if (shows_map) shine_by_map(lanes, even_emission(material), channels);
    if (material.maps.emission.texture) add_emission_of_map(lanes, material.material.phong.emission, channels);
}

void set_directions(const Fragments& fragments, const MaterialSetup& material, const LightingSetup& setup,
                    LightingChannels& channels) {
    const int lanes = lanes_for(fragments.count);
    surface_directions(fragments, lanes, setup.eye, channels);
    channels.one_v = setup.orthographic;
    if (channels.one_v) same_view_everywhere(lanes, -setup.forward, channels);
    if (material.map_needs.tangent) bend_normals(fragments, material.maps, channels);
    if (material.material.model == ReflectionModel::cook_torrance) set_viewing_angle(fragments.count, channels);
    if (needs_grain(material.material)) set_grain(fragments.count, material.material.phong, channels);
}

void start_lighting(const Fragments& fragments, const MaterialSetup& material, const LightingSetup& setup,
                    LightingChannels& channels) {
    start_surface(material, setup, channels);
    if (material.map_needs.uv) apply_maps(fragments, material, channels);
    if (material.material.model == ReflectionModel::unlit) return;
    set_directions(fragments, material, setup, channels);
}

void sample_light(const Fragments& fragments, const LightSetup& light, LightingChannels& channels) {
    const int lanes = lanes_for(fragments.count);
    channels.l.is_even = channels.irradiance.is_even = false;
    switch (light.type) {
        case LightType::directional: return sample_directional_light(lanes, light, channels);
        case LightType::point: return sample_point_light(fragments, lanes, light, channels);
        case LightType::spot: return sample_spot_light(fragments, lanes, light, channels);
    }
}

bool any_faces_light(int count, const LightingChannels& channels) {
    return lanes_facing_light(lanes_for(count), channels) > 0;
}

void shadow_light(int count, LightingChannels& channels) {
    shadow_irradiance(lanes_for(count), channels);
}

PointMaterial material_at(const MaterialSetup& setup, const LightingChannels& c, int i) {
    PointMaterial material{setup.material.model, setup.material.phong, &setup.cook_torrance, {}};
    if (setup.maps.diffuse.texture) material.phong.diffuse = c.m_D.at(i);
    if (material.model == ReflectionModel::cook_torrance) material.surface = c.microfacet.surface.at(i);
    return material;
}

void add_reflection(int count, const MaterialSetup& material, LeaveChannels leave, LightingChannels& channels) {
    const bool is_whole = count == 1 && leave != LeaveChannels::always;
    channels.is_last = leave == LeaveChannels::only_radiance && !is_whole;
    if (is_whole)
        add_whole_reflection(material, channels);
    else
        add_reflection_by_passes(count, material, channels);
}

void sum_terms(int count, LightingChannels& channels) {
    if (channels.is_summed) return;
    const int lanes = lanes_for(count);
    if (!channels.is_lit) clear_sums(lanes, channels);
    add_up(lanes, channels);
}

void copy_color(const Fragments& fragments, LightingChannels& channels) {
    const int lanes = lanes_for(fragments.count);
    for (int i = 0; i < lanes; ++i) {  // not vectorized: GCC makes it calls of memcpy
        channels.radiance.set(i, fragments.color.at(i));
    }
}

}  // namespace kreda::lighting
