// The half of the split sum that knows nothing of the environment: how much white light from all sides a surface
// reflects toward v, as a scale and a bias of F0     int D V F (n.l) dl = F0 A + B,   F = F0 + (1 - F0)(1 - v.h)^5
// Karis 2013; Gelemanovic 2018 eq. (16).
#pragma once

#include <vector>

#include "lighting/energy.hpp"
#include "lighting/material.hpp"
#include "lighting/progress.hpp"
#include "lighting/texel_taps.hpp"
#include "raster/scalar_math.hpp"

namespace kreda::lighting {

inline constexpr int kBrdfMapSize = 64;
inline constexpr int kBrdfMapSamples = 1024;

/// A and B at the nodes n.v = (i / 63)^2, roughness = j / 63. The square puts nodes where A and B bend, near grazing: the
/// worst error of bilinear interpolation is seven times smaller than with evenly spaced n.v.
struct BrdfMap {
    Distribution distribution = Distribution::ggx;
    Geometry geometry = Geometry::schlick_ggx;
    std::vector<float> texels;  ///< A, B, E_avg = 2 int (A + B) mu dmu of the row, 0; row by row of growing roughness

    [[nodiscard]] bool empty() const { return texels.empty(); }
};

/// By importance sampling: `samples` facets that v sees (Hammersley points), the same for every node.
[[nodiscard]] BrdfMap compute_brdf_map(Distribution distribution, Geometry geometry, int samples = kBrdfMapSamples,
                                       const Progress& progress = {});

/// A and B, and the energy of the roughness averaged over n.v.
struct BrdfTerms {
    float scale;  ///< A
    float bias;   ///< B
    float E_avg;  ///< 0 where it is not known
};

/// Where n.v and roughness lie among the nodes.
inline TexelTap brdf_tap(float n_dot_v, float roughness) {
    constexpr float kLast = static_cast<float>(kBrdfMapSize - 1);
    const float x = std::sqrt(raster::saturate(n_dot_v)) * kLast;
    const float y = raster::saturate(roughness) * kLast;
    const int left = static_cast<int>(x) < kBrdfMapSize - 2 ? static_cast<int>(x) : kBrdfMapSize - 2;
    const int top = static_cast<int>(y) < kBrdfMapSize - 2 ? static_cast<int>(y) : kBrdfMapSize - 2;
    return bilinear_tap(4 * (top * kBrdfMapSize + left), 4 * kBrdfMapSize, x - static_cast<float>(left),
                        y - static_cast<float>(top), 1.0f);
}

/// The map at n.v and roughness.
[[nodiscard]] BrdfTerms look_up_brdf(const BrdfMap& map, float n_dot_v, float roughness);

/// A closed form instead of a map, for GGX with Schlick-GGX's G and k = alpha / 2; cheaper, but off by up to 0.3 at grazing
/// angles.                                                                     Karis 2014, "Physically based shading on mobile"
///   r = roughness c0 + c1,   a = min(r.x^2, 2^(-9.28 n.v)) r.x + r.y,   A = -1.04 a + r.z,   B = 1.04 a + r.w
inline BrdfTerms brdf_fit(float n_dot_v, float roughness) {
    const float x = 1.0f - roughness;
    const float y = 0.0425f - 0.0275f * roughness;
    const float z = 1.04f - 0.572f * roughness;
    const float w = 0.022f * roughness - 0.04f;
    const float power = raster::exp2(-9.28f * n_dot_v);
    const float a = (x * x < power ? x * x : power) * x + y;
    const float B = 1.04f * a + w;
    return {-1.04f * a + z, B > 0.0f ? B : 0.0f, 0.0f};
}

// ------------------------------------------------------------------------------------------------ batches

/// A, B and E_avg as x, y, z at every point.
void look_up_brdf(const BrdfMap& map, int lanes, const raster::Channel& n_dot_v, const raster::Channel& roughness,
                  TapScratch& scratch, raster::Channel3& brdf);
void brdf_fit(int lanes, const raster::Channel& n_dot_v, const raster::Channel& roughness, raster::Channel3& brdf);

}  // namespace kreda::lighting
