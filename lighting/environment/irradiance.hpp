// Irradiance: all the light of an environment that falls on a plane   E(n) = int L(l) (n.l) dl     [radiance x sr]
// A constant environment L gives pi L. A white matte surface shows E / pi.
//
// Four ways: the sum over every texel (no sampling error; the reference and the default), the source's double sum over
// the hemisphere, a cosine-weighted sum, and nine spherical-harmonic coefficients.
#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "lighting/environment/cube_map.hpp"
#include "lighting/environment/progress.hpp"

namespace kreda::lighting {

/// How the sum over the hemisphere is taken (docs/51_irradiance.md).
enum class IrradianceSum { texels, cosine, hemisphere };

/// Texels a side of the level whose texels are summed for E, and for the coefficients: finer ones change nothing that
/// is seen.
inline constexpr int kIrradianceSourceSize = 64;
/// Texels a side of the cube that the nine numbers are summed over.
inline constexpr int kShSourceSize = 256;

/// The sum over all texels of the level that is `source_size` texels a side, or the nearest there is
///   E = sum of L w max(n.l, 0),   w the exact solid angle
[[nodiscard]] glm::vec3 irradiance_of_texels(const CubeMap& radiance, const glm::vec3& n,
                                             int source_size = kIrradianceSourceSize);

/// Gelemanovic 2018 eq. (13)   E = (2 pi / N1) (pi / (2 N2)) sum_i sum_j L(phi_i, theta_j) cos theta_j sin theta_j
/// N1 azimuths, N2 angles to the normal. theta_j = (j + offset) pi / (2 N2): offset 1/2 takes the middle of each step.
/// A constant environment comes out too bright by the factor x / sin x, x = pi / (2 N2); with offset 0 too dark, x cot
/// x.
[[nodiscard]] glm::vec3 irradiance_of_hemisphere(const CubeMap& radiance, const glm::vec3& n, int N1, int N2,
                                                 float offset = 0.5f);

/// E = pi / N sum of L(l) over N directions with density n.l / pi: exact where the environment is constant.
[[nodiscard]] glm::vec3 irradiance_of_cosine(const CubeMap& radiance, const glm::vec3& n, int N);

/// A cube map of E, `size` texels a side.
struct IrradianceSettings {
    IrradianceSum sum = IrradianceSum::texels;  ///< which of the sums makes it
    int azimuths = 128;                         ///< N1; the cosine-weighted sum takes N1 N2 samples
    int angles = 32;                            ///< N2
    int size = 32;                              ///< texels a side of each face
};

/// A cube map of irradiance, linear RGB, from one of radiance.
[[nodiscard]] CubeMap irradiance_map(const CubeMap& radiance, const IrradianceSettings& settings,
                                     const Progress& progress = {});

// --------------------------------------------------------------------------------------- spherical harmonics

/// E as a polynomial of the second degree in n: nine coefficients a colour.   Ramamoorthi & Hanrahan 2001
struct Sh9 {
    std::array<glm::vec3, 9> c{};  ///< A_l L_lm times the constant of Y_lm
};

/// The nine basis functions without their constants:  1, y, z, x, xy, yz, 3z^2 - 1, xz, x^2 - y^2.   d unit.
inline std::array<float, 9> sh_polynomials(const glm::vec3& d) {
    return {1.0f, d.y, d.z, d.x, d.x * d.y, d.y * d.z, 3.0f * d.z * d.z - 1.0f, d.x * d.z, d.x * d.x - d.y * d.y};
}

/// c_lm = A_l K_lm^2 sum over texels of L w P_lm,   A = pi, 2 pi / 3, pi / 4
[[nodiscard]] Sh9 project_to_sh9(const CubeMap& radiance);

/// The coefficients of a light of unit irradiance from direction l.
[[nodiscard]] Sh9 sh9_of_light(const glm::vec3& l);

/// E(n), not below 0: beside a small bright light the polynomial dips below by up to 4 % of it.   n unit.
inline glm::vec3 irradiance_of_sh9(const Sh9& sh, const glm::vec3& n) {
    const std::array<float, 9> p = sh_polynomials(n);
    glm::vec3 sum(0.0f);
    for (int k = 0; k < 9; ++k) sum += sh.c[k] * p[k];
    return {sum.x > 0.0f ? sum.x : 0.0f, sum.y > 0.0f ? sum.y : 0.0f, sum.z > 0.0f ? sum.z : 0.0f};
}

/// The same for a batch.
void irradiance_of_sh9(Sh9 sh, int lanes, const raster::Channel3& n, raster::Channel3& E);

}  // namespace kreda::lighting
