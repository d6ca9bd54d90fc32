#include "tools/measure/experiment_functions.hpp"

namespace kreda::tools {

const std::vector<Experiment>& experiments() {
    static const std::vector<Experiment> all = {
        {"depth", "How far apart must two surfaces be for each depth format, with the far plane ever farther?",
         measure_depth},
        {"affine", "What does interpolation without perspective miss, against tessellation?", measure_affine},
        {"supersampling", "How far are n x n samples a pixel from 64, and what do they take?", measure_supersampling},
        {"texture_filter", "How far is each texture filter from the mean of what a pixel sees?",
         measure_texture_filter},
        {"frequency", "Flat, Gouraud, Phong: what does light per triangle or vertex miss, against tessellation?",
         measure_frequency},
        {"shading_rate", "What does one shading point for 2 x 2 or 4 x 4 pixels miss?", measure_shading_rate},
        {"phong_blinn", "How far is Blinn-Phong with exponent 4h from Phong with h, over h and incidence?",
         measure_phong_blinn},
        {"fresnel", "How far is each Fresnel method from Fresnel's equations, over all angles?", measure_fresnel},
        {"fresnel_table", "How large must a table of F be?", measure_fresnel_table},
        {"fresnel_time", "What does each Fresnel method take?", measure_fresnel_time},
        {"fresnel_pictures", "How far is each Fresnel method off in pictures, from all around?",
         measure_fresnel_pictures},
        {"spectrum", "What do three wavelengths miss of the spectrum?", measure_spectrum},
        {"furnace", "How much of an even white light does a white microfacet surface give back, for each D and G?",
         measure_furnace},
        {"shadow_map", "How wrong is a shadow map, over its size, bias and filter?", measure_shadow_map},
        {"soft_shadow", "How far are pcf and pcss from a wide lamp?", measure_soft_shadow},
        {"irradiance", "How many samples does irradiance take?", measure_irradiance},
        {"sh9", "How wide must a light be for nine numbers to hold its irradiance?", measure_sh9},
        {"prefilter", "How many samples does a blurred environment take?", measure_prefilter},
        {"brdf_map", "How large must the BRDF map be, and where should its nodes stand?", measure_brdf_map},
        {"brdf_fit", "How far is a closed form from the BRDF map, and what does it take?", measure_brdf_fit},
        {"split_sum", "How far is the split sum from the integral?", measure_split_sum},
        {"fog", "What do planar fog and fog per vertex miss?", measure_fog},
        {"float", "How far are the formulas in float from double?", measure_float},
        {"exactness", "What does it cost to be exact: roots, pow, sub-pixel bits, a film of floats?",
         measure_exactness},
        {"transfer", "How many codes lie between sRGB's curve and a power of 2.2?", measure_transfer},
    };
    return all;
}

const Experiment* find_experiment(std::string_view name) {
    for (const Experiment& experiment : experiments()) {
        if (experiment.name == name) return &experiment;
    }
    return nullptr;
}

}  // namespace kreda::tools
