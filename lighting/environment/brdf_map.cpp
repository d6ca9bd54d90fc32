#include "lighting/environment/brdf_map.hpp"

#include <algorithm>
#include <memory>

#include "lighting/batch/add_light.hpp"
#include "lighting/batch/microfacet_passes.hpp"
#include "lighting/importance.hpp"
#include "raster/platform.hpp"

namespace kreda::lighting {

namespace {

using raster::Channel;

struct RowScratch {
    LightingChannels lighting;
    Channel scale, bias;
};

/// One node a lane: v at its angle in the x-z plane, n = (0, 0, 1).
void place_nodes(float roughness, RowScratch& row) {
    LightingChannels& c = row.lighting;
    for (int i = 0; i < raster::lanes_for(kBrdfMapSize); ++i) {
        const float s = static_cast<float>(i < kBrdfMapSize ? i : 0) / static_cast<float>(kBrdfMapSize - 1);
        const float mu = s * s > 1e-4f ? s * s : 1e-4f;  // there is a limit at 0, but the samples do not reach it
        c.n.set(i, {0.0f, 0.0f, 1.0f});
        c.v.set(i, {std::sqrt((1.0f - mu) * (1.0f + mu)), 0.0f, mu});
        row.scale.set(i, 0.0f);
        row.bias.set(i, 0.0f);
    }
    MicrofacetSurface surface;
    surface.f0 = glm::vec3(1.0f);
    surface.roughness = roughness;
    surface.alpha = alpha_from_roughness(roughness);
    c.microfacet.surface.set_all(surface);
    fill_surface(kBrdfMapSize, c.microfacet.surface);
    set_viewing_angle(kBrdfMapSize, c);
}

KREDA_BATCH_LOOP void reflect_at_facets(int lanes, glm::vec2 u, LightingChannels& c) {
    for (int i = 0; i < lanes; ++i) {
        const glm::vec3 v = c.v.at(i);
        set_direction_to_light(c, i, mirror_vector(visible_half_vector(u, v, c.microfacet.surface.alpha.at(i)), v));
    }
}

/// A and B: the mean of f (n.l) / p, split by F = F0 (1 - F_c) + F_c. For F = 1 it is the directional albedo A + B,
/// which energy.cpp computes in its own way and says why.
KREDA_BATCH_LOOP void add_sample(int lanes, const MicrofacetChannels& m, Channel& scale, Channel& bias) {
    for (int i = 0; i < lanes; ++i) {
        const float w = visible_weight(m, i);
        const float F_c = schlick_weight(m.v_dot_h.at(i));
        scale.set(i, scale.at(i) + (1.0f - F_c) * w);
        bias.set(i, bias.at(i) + F_c * w);
    }
}

/// 2 int E mu dmu = 4 int E s^3 ds, mu = s^2, over the nodes by the trapezoidal rule with corrected ends: 3/8, 7/6,
/// 23/24, 1, 1, ... Exact for cubic polynomials, so a mirror's E = 1 gives 1.                         Gregory 1670
float average_energy(const RowScratch& row) {
    constexpr int kLast = kBrdfMapSize - 1;
    constexpr double kEnds[] = {3.0 / 8.0, 7.0 / 6.0, 23.0 / 24.0};
    double sum = 0.0;
    for (int i = 0; i <= kLast; ++i) {
        const double s = static_cast<double>(i) / kLast;
        const double E = double(row.scale.at(i)) + double(row.bias.at(i));
        const int from_end = std::min(i, kLast - i);
        sum += (from_end < 3 ? kEnds[from_end] : 1.0) * 4.0 * s * s * s * E;
    }
    return static_cast<float>(sum / kLast);
}

KREDA_BATCH_LOOP void set_taps(int lanes, const Channel& n_dot_v, const Channel& roughness, TapChannels& taps) {
    for (int i = 0; i < lanes; ++i) taps.set(i, brdf_tap(n_dot_v.at(i), roughness.at(i)));
}

KREDA_BATCH_LOOP void set_taps_of_row(int lanes, const Channel& n_dot_v, float roughness, TapChannels& taps) {
    for (int i = 0; i < lanes; ++i) taps.set(i, brdf_tap(n_dot_v.at(i), roughness));
}

}  // namespace

BrdfMap compute_brdf_map(Distribution distribution, Geometry geometry, int samples, const Progress& progress) {
    CookTorranceSetup setup;
    setup.distribution = distribution;
    setup.geometry = geometry;
    setup.fresnel = FresnelMethod::none;
    BrdfMap map{distribution, geometry, {}};
    map.texels.assign(std::size_t(4) * kBrdfMapSize * kBrdfMapSize, 0.0f);
    WorkCounter counter(kBrdfMapSize, progress);
#pragma omp parallel
    {
        const auto row = std::make_unique<RowScratch>();
#pragma omp for schedule(dynamic)
        for (int j = 0; j < kBrdfMapSize; ++j) {
            const int lanes = raster::lanes_for(kBrdfMapSize);
            place_nodes(static_cast<float>(j) / static_cast<float>(kBrdfMapSize - 1), *row);
            for (int k = 0; k < samples; ++k) {
                reflect_at_facets(lanes, hammersley(k, samples), row->lighting);
                evaluate_microfacets(kBrdfMapSize, setup, LitBy::image, row->lighting);
                add_sample(lanes, row->lighting.microfacet, row->scale, row->bias);
            }
            for (int i = 0; i < kBrdfMapSize; ++i) {
                row->scale.set(i, row->scale.at(i) / static_cast<float>(samples));
                row->bias.set(i, row->bias.at(i) / static_cast<float>(samples));
            }
            const float E_avg = average_energy(*row);
            for (int i = 0; i < kBrdfMapSize; ++i) {
                float* texel = &map.texels[std::size_t(4) * (std::size_t(j) * kBrdfMapSize + std::size_t(i))];
                texel[0] = row->scale.at(i);
                texel[1] = row->bias.at(i);
                texel[2] = E_avg;
            }
            counter.add(1.0);
        }
    }
    return map;
}

BrdfTerms look_up_brdf(const BrdfMap& map, float n_dot_v, float roughness) {
    const glm::vec3 terms = weighted_sum(map.texels.data(), brdf_tap(n_dot_v, roughness));
    return {terms.x, terms.y, terms.z};
}

void look_up_brdf(const BrdfMap& map, int lanes, const Channel& n_dot_v, const Channel& roughness, TapScratch& scratch,
                  raster::Channel3& brdf) {
    set_taps(lanes, n_dot_v, roughness, scratch.taps[0]);
    read_taps(map.texels.data(), lanes, 1, scratch);
    split_texels(lanes, scratch, brdf);
}

void look_up_brdf(const BrdfMap& map, int lanes, const Channel& n_dot_v, float roughness, TapScratch& scratch,
                  raster::Channel3& brdf) {
    set_taps_of_row(lanes, n_dot_v, roughness, scratch.taps[0]);
    read_taps(map.texels.data(), lanes, 1, scratch);
    split_texels(lanes, scratch, brdf);
}

KREDA_BATCH_LOOP void brdf_fit(int lanes, const Channel& n_dot_v, const Channel& roughness, raster::Channel3& brdf) {
    for (int i = 0; i < lanes; ++i) {
        const BrdfTerms terms = brdf_fit(n_dot_v.at(i), roughness.at(i));
        brdf.set(i, {terms.scale, terms.bias, terms.E_avg});
    }
}

}  // namespace kreda::lighting
