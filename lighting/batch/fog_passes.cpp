#include "lighting/batch/fog_passes.hpp"

#include "lighting/fog.hpp"
#include "raster/platform.hpp"
#include "raster/scalar_math.hpp"

namespace kreda::lighting {

namespace {

using raster::Fragments;
using raster::lanes_for;

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

KREDA_BATCH_LOOP void mix_with_fog(int lanes, glm::vec3 c_f, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) c.radiance.set(i, mix_fog(c.fog.at(i), c.radiance.at(i), c_f));
}

}  // namespace

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
    // Weights sum to 1 but for their last bits. Above 1, mix_fog would take the fog's light away.
    for (int i = 0; i < fragments.count; ++i) channels.fog.set(i, raster::saturate(fragments.fog.at(i)));
}

void apply_fog(int count, const glm::vec3& fog_color, LightingChannels& channels) {
    mix_with_fog(lanes_for(count), fog_color, channels);
}

}  // namespace kreda::lighting
