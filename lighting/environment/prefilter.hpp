// The other half of the split sum: the environment as a mirror of each roughness blurs it, seen along its own normal
// (v = r = n), one level of a cube map for each roughness.                    Karis 2013; Gelemanovic 2018, section 3.2
//   prefiltered(r) = sum of L(l_k) (n.l_k) / sum of (n.l_k),   l_k = n mirrored in facets h_k chosen by  D (n.h)
#pragma once

#include <vector>

#include "lighting/environment/cube_map.hpp"
#include "lighting/environment/progress.hpp"
#include "raster/scalar_math.hpp"

namespace kreda::lighting {

/// Level 0 is the mirror, level 7 roughness 1; alpha doubles from one to the next:  alpha = 2^(level - 7).
/// A lobe is about twice as wide as that of the level before, so what lies between two levels is well mixed from both.
inline constexpr int kPrefilterLevels = 8;

/// Alpha of a level: 0 at level 0, doubling up to 1 at the last.
[[nodiscard]] inline float alpha_of_level(int level) {
    return level == 0 ? 0.0f : raster::exp2(static_cast<float>(level - (kPrefilterLevels - 1)));
}

/// The level of an alpha:  7 + log2 alpha,  and between the mirror and level 1 in proportion to alpha.
inline float level_of_alpha(float alpha) {
    constexpr float kLast = static_cast<float>(kPrefilterLevels - 1);
    constexpr float kFirstAlpha = 1.0f / 64.0f;
    const float blurred = kLast + raster::log2(alpha > kFirstAlpha ? alpha : kFirstAlpha);
    return alpha < kFirstAlpha ? alpha * (1.0f / kFirstAlpha) : blurred;
}

/// How the levels are baked.
struct PrefilterSettings {
    int samples = 2048;  ///< at roughness 1; a level takes samples x alpha, at least 32: a narrow lobe has less to miss
    int largest_blurred = 256;  ///< texels a side of level 1 at most
    bool blurred = true;        ///< false: the mirror alone (nothing but a background needs it)
    bool mirror = true;         ///< level 0 is looked at by itself, too
    int first_level = 0;        ///< of those that some roughness reads: what lies before is one texel a side,
    int last_level = kPrefilterLevels - 1;  ///< and what lies behind this one is not there
};

/// Texels a side of each level, for an environment of `size` texels a side; and the samples that a level takes.
[[nodiscard]] std::vector<int> prefilter_sizes(int size, const PrefilterSettings& settings);
/// Samples of a level: in proportion to its alpha, 32 at least.
[[nodiscard]] int samples_of_level(const PrefilterSettings& settings, int level);

/// Level 0 copies level 0 of `radiance` (where it is wanted); a level of alpha is 8 / alpha texels a side, or less
/// where those two are smaller. Samples are read from the mip level of `radiance` whose texels are as large as the
/// sample's share of the lobe,
///   lod = log2(w_s / w_p) / 2,   w_s = 1 / (N p),   p = D / 4,   w_p = 4 pi / (6 size^2)       Krivanek & Colbert 2008
/// so that a small sun makes no fireflies. `radiance` must have all its mip levels.
[[nodiscard]] CubeMap prefilter(const CubeMap& radiance, const PrefilterSettings& settings,
                                const Progress& progress = {});

/// One direction of one alpha, for laws and lessons. From a map of a single level these are plain samples.
[[nodiscard]] glm::vec3 prefiltered_radiance(const CubeMap& radiance, const glm::vec3& n, float alpha, int samples);

/// The same for many directions of any length.
[[nodiscard]] std::vector<glm::vec3> prefiltered_radiance(const CubeMap& radiance, const std::vector<glm::vec3>& n,
                                                          float alpha, int samples);

}  // namespace kreda::lighting
