#include "lighting/batch/passes.hpp"

#include "lighting/batch/microfacet_passes.hpp"
#include "lighting/batch/model_loop.hpp"
#include "lighting/batch/ward_passes.hpp"
#include "lighting/reflection.hpp"
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
KREDA_BATCH_LOOP void start_terms(int lanes, const glm::vec3& own_radiance, LightingChannels& c) {
    const glm::vec3 base = own_radiance;
    for (int i = 0; i < lanes; ++i) {
        c.ambient.set(i, base);
        c.diffuse.set(i, glm::vec3(0.0f));
        c.specular.set(i, glm::vec3(0.0f));
    }
}

/// Where a map says how much each point emits: m_E is the map times the constant.
KREDA_BATCH_LOOP void add_emission_of_map(int lanes, const glm::vec3& emission, LightingChannels& c) {
    const glm::vec3 constant = emission;
    for (int i = 0; i < lanes; ++i) c.ambient.set(i, c.ambient.at(i) + constant * c.map_emission.at(i));
}

/// Unlit: what the map shows, and m_E.
KREDA_BATCH_LOOP void shine_by_map(int lanes, const glm::vec3& emission, LightingChannels& c) {
    const glm::vec3 m_E = emission;
    for (int i = 0; i < lanes; ++i) c.ambient.set(i, c.m_D.at(i) + m_E);
}

/// What one light sends to point i. Returns 1 where the surface faces it, else 0.
inline int set_light(LightingChannels& c, int i, const LightSample& s) {
    c.irradiance.set(i, s.irradiance);
    return set_direction_to_light(c, i, s.l) > 0.0f ? 1 : 0;
}

// The loops over a light return how many lanes face it, the ones behind the last point among them.

KREDA_BATCH_LOOP int sample_directional_light(int lanes, const LightSetup& setup, LightingChannels& c) {
    const LightSetup light = setup;
    int facing = 0;
    for (int i = 0; i < lanes; ++i) facing += set_light(c, i, sample_directional(light));
    return facing;
}

KREDA_BATCH_LOOP int sample_point_light(const Fragments& f, int lanes, const LightSetup& setup, LightingChannels& c) {
    const LightSetup light = setup;
    int facing = 0;
    for (int i = 0; i < lanes; ++i) facing += set_light(c, i, sample_point(light, f.position.at(i)));
    return facing;
}

KREDA_BATCH_LOOP int sample_spot_light(const Fragments& f, int lanes, const LightSetup& setup, LightingChannels& c) {
    const LightSetup light = setup;
    int facing = 0;
    for (int i = 0; i < lanes; ++i) facing += set_light(c, i, sample_spot(light, f.position.at(i)));
    return facing;
}

KREDA_BATCH_LOOP void add_lambert(int lanes, const PhongMaterial& material, bool map, LightingChannels& c) {
    add_model(lanes, material, map, c,
              [&c](int i, const PhongMaterial& m) { return lambert(c.n.at(i), c.l.at(i), m); });
}

/// Sigma at point i. Returns 1 where its highlight can be seen: on the side that faces the light, and above `least`.
inline int set_sigma(LightingChannels& c, int i, float sigma, float least) {
    c.sigma.set(i, sigma);
    return sigma * faces_light(c.n_dot_l.at(i)) > least ? 1 : 0;
}

// The loops over Sigma return how many lanes have a highlight.

KREDA_BATCH_LOOP int find_sigma_phong(int lanes, float least, LightingChannels& c) {
    int shining = 0;
    for (int i = 0; i < lanes; ++i) {
        const glm::vec3 r = mirror_vector(c.n.at(i), c.l.at(i), c.n_dot_l.at(i));
        shining += set_sigma(c, i, sigma_phong(c.v.at(i), r), least);
    }
    return shining;
}

KREDA_BATCH_LOOP int find_sigma_blinn(int lanes, float least, LightingChannels& c) {
    int shining = 0;
    for (int i = 0; i < lanes; ++i) {
        const glm::vec3 h = half_vector(c.l.at(i), c.v.at(i));
        shining += set_sigma(c, i, sigma_blinn(c.n.at(i), h), least);
    }
    return shining;
}

/// The highlight   Sigma^h, 0 on the side that faces away from the light.
/// pow in two loops: the shorter a loop, the more points a processor has under way (a seventh faster).
KREDA_BATCH_LOOP void raise_sigma(int lanes, float shininess, LightingChannels& c) {
    const float h = shininess;
    raster::Channel high, low;
    for (int i = 0; i < lanes; ++i) {
        const raster::TwoFloats exponent = raster::log2_of_pow(c.sigma.at(i), h);
        high.set(i, exponent.high);
        low.set(i, exponent.low);
    }
    for (int i = 0; i < lanes; ++i) {
        const float power = raster::pow_from_log2({high.at(i), low.at(i)}, h);
        c.highlight.set(i, power * faces_light(c.n_dot_l.at(i)));
    }
}

KREDA_BATCH_LOOP void no_highlight(int lanes, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) c.highlight.set(i, 0.0f);  // not vectorized: GCC makes it a call of memset
}

KREDA_BATCH_LOOP void add_phong_terms(int lanes, const PhongMaterial& material, bool map, LightingChannels& c) {
    add_model(lanes, material, map, c,
              [&c](int i, const PhongMaterial& m) { return phong_terms(c.n_dot_l.at(i), c.highlight.at(i), m); });
}

/// Phong and Blinn-Phong. Up to Sigma = 2^(-127/h) the power is below 2^-126, which pow counts as 0; where no point of
/// the batch exceeds it, nothing need be raised. (0^0 = 1: a shininess of 0 lights everything that faces the light.)
void add_highlights(int lanes, const Material& material, bool map, LightingChannels& c) {
    const float h = material.phong.shininess;
    const float least = raster::exp2(-127.0f / h);
    const bool mirrors = material.model == ReflectionModel::phong;
    const int shining = mirrors ? find_sigma_phong(lanes, least, c) : find_sigma_blinn(lanes, least, c);
    if (shining > 0 || h == 0.0f)
        raise_sigma(lanes, h, c);
    else
        no_highlight(lanes, c);
    add_phong_terms(lanes, material.phong, map, c);
}

KREDA_BATCH_LOOP void shadow_irradiance(int lanes, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) c.irradiance.set(i, c.shadow.at(i) * c.irradiance.at(i));
}

KREDA_BATCH_LOOP void add_up(int lanes, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) c.radiance.set(i, c.ambient.at(i) + c.diffuse.at(i) + c.specular.at(i));
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
    start_terms(lanes, own_radiance(material, setup.ambient), channels);
    if (model == ReflectionModel::cook_torrance) {
        fill_surface(fragments.count, material.cook_torrance, channels.microfacet);
    }
    if (material.map_needs.uv) read_maps(fragments, material.maps, material.cook_torrance, channels);
    const bool shows_map = model == ReflectionModel::unlit && material.maps.diffuse.texture;
    if (shows_map) shine_by_map(lanes, even_emission(material), channels);
    if (material.maps.emission.texture) add_emission_of_map(lanes, material.material.phong.emission, channels);
    if (model == ReflectionModel::unlit) return;
    surface_directions(fragments, lanes, setup, channels);
    if (setup.orthographic) same_view_everywhere(lanes, -setup.forward, channels);
    if (material.map_needs.tangent) bend_normals(fragments, material.maps, channels);
    if (model == ReflectionModel::cook_torrance) find_viewing_angle(fragments.count, channels);
    if (needs_grain(material.material)) find_grain(fragments.count, material.material.phong, channels);
}

bool sample_light(const Fragments& fragments, const LightSetup& light, LightingChannels& channels) {
    const int lanes = lanes_for(fragments.count);
    switch (light.type) {
        case LightType::directional: return sample_directional_light(lanes, light, channels) > 0;
        case LightType::point: return sample_point_light(fragments, lanes, light, channels) > 0;
        case LightType::spot: return sample_spot_light(fragments, lanes, light, channels) > 0;
    }
    return false;
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
        case ReflectionModel::phong:
        case ReflectionModel::blinn_phong: return add_highlights(lanes, setup.material, map, c);
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
