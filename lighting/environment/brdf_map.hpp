// The half of the split sum that knows nothing of the environment: how much white light from all sides a surface
// reflects toward v, as a scale and a bias of F0     int D V F (n.l) dl = F0 A + B,   F = F0 + (1 - F0)(1 - v.h)^5
// Karis 2013; Gelemanovic 2018 eq. (16).
#pragma once

#include <vector>

#include "lighting/environment/progress.hpp"
#include "lighting/environment/texel_taps.hpp"
#include "lighting/material.hpp"
#include "raster/scalar_math.hpp"

namespace kreda::lighting {

/// Nodes a side of the map.
inline constexpr int kBrdfMapSize = 64;
/// Samples a node.
inline constexpr int kBrdfMapSamples = 1024;

/// A and B at the nodes n.v = (i / 63)^2, roughness = j / 63. The square puts nodes where A and B bend, near grazing:
/// the worst error of bilinear interpolation is seven times smaller than with evenly spaced n.v.
struct BrdfMap {
    Distribution distribution = Distribution::ggx;  ///< the D that A and B were summed with
    Geometry geometry = Geometry::schlick_ggx;      ///< and the G
    std::vector<float> texels;  ///< A, B, E_avg = 2 int (A + B) mu dmu of the row, 0; row by row of growing roughness

    /// Has it no nodes yet?
    [[nodiscard]] bool empty() const {
        return texels.empty();
    }
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

/// A closed form instead of a map, for GGX with Smith's height-correlated G (not Schlick-GGX: there it is off by 0.33
/// at grazing angles). Ratios of polynomials of the second degree in n.v and alpha, the form of MaterialX's fit (2020);
/// the numbers are least squares against our own quadrature. Of F0 A + B at F0 = 1 it misses 0.7 % in the mean and
/// 0.067 at worst (grazing, roughness 0.1). Karis' fit for mobiles (2014) misses 14 % in the mean and up to 0.49,
/// Hirvonen's (Ray Tracing Gems, 2019, chapter 32) 4 % and up to 0.34.
///   A = (a . p) / (1 + b . p),   B likewise,   p = 1, x, y, xy, x^2, y^2, x^2 y, x y^2, x^2 y^2,   x = n.v,  y = alpha
inline BrdfTerms brdf_fit(float n_dot_v, float roughness) {
    const float x = n_dot_v, y = roughness * roughness, xy = x * y, x2 = x * x, y2 = y * y;
    const float x2y = x2 * y, xy2 = x * y2, x2y2 = x2 * y2;
    const float A_above = 0.03833f + 2.469f * x + 10.17f * y - 27.91f * xy + 14.23f * x2 - 9.441f * y2 + 26.55f * x2y +
                          43.7f * xy2 - 44.91f * x2y2;
    const float A_below = 1.0f + 0.2998f * x + 8.603f * y - 14.86f * xy + 15.39f * x2 - 8.769f * y2 + 12.39f * x2y +
                          38.77f * xy2 - 2.377f * x2y2;
    const float B_above = 0.9704f - 2.358f * x + 7.017f * y - 14.41f * xy + 1.408f * x2 - 3.554f * y2 + 7.46f * x2y +
                          6.203f * xy2 - 2.74f * x2y2;
    const float B_below = 1.0f + 1.226f * x + 23.75f * y - 110.1f * xy + 11.57f * x2 + 96.01f * y2 + 235.7f * x2y +
                          576.9f * xy2 - 835.9f * x2y2;
    return {raster::saturate(A_above / A_below), raster::saturate(B_above / B_below),
            0.0f};  // both below: 0.15 or more
}

// ------------------------------------------------------------------------------------------------ batches

/// A, B and E_avg as x, y, z at every point.
void look_up_brdf(const BrdfMap& map, int lanes, const raster::Channel& n_dot_v, const raster::Channel& roughness,
                  TapScratch& scratch, raster::Channel3& brdf);
/// The same where all points have the same roughness.
void look_up_brdf(const BrdfMap& map, int lanes, const raster::Channel& n_dot_v, float roughness, TapScratch& scratch,
                  raster::Channel3& brdf);
/// The closed form for `lanes` points at once.
void brdf_fit(int lanes, const raster::Channel& n_dot_v, const raster::Channel& roughness, raster::Channel3& brdf);

}  // namespace kreda::lighting
