// Fresnel's coefficient F: which share of the light a smooth surface reflects, by angle, per colour channel.
// Source: Stetic-Kozic 2014, "Poredjenje metoda za racunanje koeficijenata Frenelove refleksije": equations by number.
//
// c = cos theta, in [0, 1], theta between the light and the normal of the (micro)facet.
// n + i k: index of refraction of what lies behind the surface relative to what lies before it, n in [0.001, 1000], k
// in [0, 1000]; k = 0 for dielectrics. R_0 in [0, 1.1]. F is in [0, 1], unless R_0 is above 1. The errors of all of
// them: docs/97_extremes.md. Every function here is one scalar formula without a branch, so a loop over it vectorizes;
// the vec3 forms apply it to red, green and blue.
#pragma once

#include <cmath>
#include <functional>

#include <glm/vec3.hpp>

#include "lighting/tables.hpp"
#include "raster/scalar_math.hpp"

namespace kreda::lighting {

/// F for light that swings across (s) and within (p) the plane of incidence.
struct PolarizedFresnel {
    float s;  ///< in [0, 1]
    float p;  ///< in [0, 1]
};

/// Unpolarized light is half of each   F = (R_s + R_p) / 2                                        eq. (3), (12)
inline float unpolarized(const PolarizedFresnel& F) {
    return 0.5f * (F.s + F.p);
}

/// Index of refraction relative to the medium the light comes from   n = n_2 / n_1               section 2.1
inline float relative_index(float n_1, float n_2) {
    return n_2 / n_1;
}

/// Cosine of the refracted ray (Snell)   cos^2 theta_t = 1 - (1 - c^2) / n^2.   Beyond the critical angle: 0.  In [0,
/// 1]. Times n^2 it is n^2 - 1 + c^2, which does not cancel as n nears 1, or n^2 - sin^2, which does not for small n.
inline float refracted_cosine(float c, float n) {
    const float near_one = ((n - 1.0f) * (n + 1.0f) + c * c) / (n * n);
    const float small = 1.0f - (1.0f - c) * (1.0f + c) / (n * n);
    return std::sqrt(raster::saturate(n < 0.7f ? small : near_one));
}

// ----------------------------------------------------------------------------------------------------- exact

/// Exact, dielectric, any n > 0:   g^2 = n^2 - 1 + c^2
///   R_s = ((g - c) / (g + c))^2      R_p = R_s ((c (g + c) - 1) / (c (g - c) + 1))^2         Cook & Torrance 1982
/// the closed form of eq. (1) and (2).
/// g - c is taken as (n^2 - 1) / (g + c), which does not cancel as n nears 1.  g^2 < 0: total reflection, F = 1.
/// F rises to 1 at the critical angle with no bound to its slope: there the rounding of g^2 counts. For small n it is
/// less in n^2 - sin^2.   R_s and R_p exceed 1 by 3e-7 at most.
inline PolarizedFresnel fresnel_dielectric_polarized(float c, float n) {
    const float n2_minus_1 = (n - 1.0f) * (n + 1.0f);
    const float g2 = n < 0.7f ? n * n - (1.0f - c) * (1.0f + c) : n2_minus_1 + c * c;
    const float g = std::sqrt(g2 > 0.0f ? g2 : 0.0f);
    const float sum = g + c > 1e-18f ? g + c : 1e-18f;  // 0 only for n = 1 at 90 degrees: nothing is there, F = 0
    const float r_s = n2_minus_1 / (sum * sum);
    const float difference = n2_minus_1 / sum;
    const float p_by_s = (c * sum - 1.0f) / (c * difference + 1.0f);
    const float r_p = r_s * p_by_s;
    const bool total = g2 < 0.0f;
    return {total ? 1.0f : r_s * r_s, total ? 1.0f : r_p * r_p};
}

/// Exact F of unpolarized light: half of s and half of p. c in [0, 1].
inline float fresnel_dielectric(float c, float n) {
    return raster::smaller_of_positive(unpolarized(fresnel_dielectric_polarized(c, n)), 1.0f);
}

/// Exact, conductor (and dielectric with k = 0):   s^2 = 1 - c^2,   A = n^2 - k^2 - s^2,   B = 2 n k,
///   2 a^2 = sqrt(A^2 + B^2) + A      2 b^2 = sqrt(A^2 + B^2) - A                                eq. (8), (9)
///   R_s = ((a - c)^2 + b^2) / ((a + c)^2 + b^2)                                                 eq. (10)
///   R_p = R_s ((a c - s^2)^2 + (b c)^2) / ((a c + s^2)^2 + (b c)^2)                       eq. (11) times cos^2 / cos^2
/// As printed, (8) cancels for good metals (A << 0) and (9) for dielectrics. So only the larger of a, b comes from its
/// root; the smaller from a b = B / 2. And no tan theta, whose float changes sign at 90 degrees. Where hardly anything
/// is there, n near 1 and k near 0, A is nearly 0: n^2 - 1 - k^2 + c^2 keeps its digits.
inline PolarizedFresnel fresnel_conductor_polarized(float c, float n, float k) {
    const float s2 = (1.0f - c) * (1.0f + c);
    const bool is_faint = std::abs(n - 1.0f) + k < 0.5f;
    const float faint_A = (n - 1.0f) * (n + 1.0f) - k * k + c * c;
    const float A = is_faint ? faint_A : (n - k) * (n + k) - s2;
    const float B = 2.0f * n * k;
    const float root = std::sqrt(A * A + B * B);
    const float larger = std::sqrt(0.5f * (root + std::abs(A)));
    const float smaller = 0.5f * B / (larger > 1e-18f ? larger : 1e-18f);
    const float a = A >= 0.0f ? larger : smaller;
    const float b = A >= 0.0f ? smaller : larger;

    const float s_above = (a - c) * (a - c) + b * b;
    const float s_below = (a + c) * (a + c) + b * b;
    const float ac = a * c;
    const float bc2 = (b * c) * (b * c);
    const float p_above = (ac - s2) * (ac - s2) + bc2;
    const float p_below = (ac + s2) * (ac + s2) + bc2;
    // s_below is 0 only for n = 1, k = 0 at 90 degrees: nothing is there, F = 0.
    const float R_s = s_above / (s_below > 1e-30f ? s_below : 1e-30f);
    return {R_s, R_s * (p_above / p_below)};
}

/// Exact F of unpolarized light for n + i k: half of s and half of p. c in [0, 1].
inline float fresnel_conductor(float c, float n, float k) {
    return raster::smaller_of_positive(unpolarized(fresnel_conductor_polarized(c, n, k)), 1.0f);
}

/// F at normal incidence   R_0 = ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2)                             section 3.2.2
inline float f0_from_index(float n, float k) {
    return ((n - 1.0f) * (n - 1.0f) + k * k) / ((n + 1.0f) * (n + 1.0f) + k * k);
}

/// The dielectric that has this R_0   n = (1 + sqrt R_0) / (1 - sqrt R_0)               Cook & Torrance 1982, section 2
/// R_0 is kept in [0, 0.9999]: a mirror has no finite n. For a metal known by its colour only; the curve is a
/// dielectric's.
inline float index_from_f0(float f0) {
    const float at_least_0 = f0 > 0.0f ? f0 : 0.0f;
    const float root = std::sqrt(at_least_0 < 0.9999f ? at_least_0 : 0.9999f);
    return (1.0f + root) / (1.0f - root);
}

// ------------------------------------------------------------------------------------------------ Schlick's

/// Schlick's weight   (1 - c)^5                                                                    Schlick 1994
inline float schlick_weight(float c) {
    const float x = 1.0f - c;
    const float x2 = x * x;
    return x2 * x2 * x;
}

/// Schlick from R_0   F = R_0 + (1 - R_0) (1 - c)^5                                             eq. (13), Schlick 1994
/// Exactly 1 at 90 degrees. R_0 of a colour outside sRGB may exceed 1 (gold's red: 1.04); then F falls to 1.
inline float fresnel_schlick(float c, float f0) {
    return f0 + (1.0f - f0) * schlick_weight(c);
}

/// Schlick from n, between dielectrics   F = ((n - 1)^2 + 4 n (1 - c)^5) / (n + 1)^2                      eq. (7)
/// As printed it knows no total reflection: for n < 1 use fresnel_schlick_between.
inline float fresnel_schlick_from_index(float c, float n) {
    const float above = (n - 1.0f) * (n - 1.0f) + 4.0f * n * schlick_weight(c);
    return raster::smaller_of_positive(above / ((n + 1.0f) * (n + 1.0f)), 1.0f);
}

/// Schlick between any two media: leaving the denser one (n < 1) the angle that counts is the refracted one; beyond the
/// critical angle F = 1.
inline float fresnel_schlick_between(float c, float n) {
    const float c_t = refracted_cosine(c, n);
    return fresnel_schlick_from_index(n < 1.0f ? c_t : c, n);
}

/// Rescaled Schlick   F = ((n - 1)^2 + 4 n (1 - c)^5 + k^2) / ((n + 1)^2 + k^2)                          eq. (14)
/// Lazanyi & Szirmay-Kalos 2005. It is fresnel_schlick(c, f0_from_index(n, k)), written with n and k.
inline float fresnel_rescaled_schlick(float c, float n, float k) {
    const float above = (n - 1.0f) * (n - 1.0f) + 4.0f * n * schlick_weight(c) + k * k;
    return raster::smaller_of_positive(above / ((n + 1.0f) * (n + 1.0f) + k * k), 1.0f);
}

/// Corrected Schlick as Lazanyi & Szirmay-Kalos published it   F = F_14 - a c (1 - c)^lambda,   a = 2 n
/// It is this form that gives the numbers of the thesis' table 2. F(90 degrees) = 1, for c multiplies the correction.
/// a and lambda: see fit_correction(); a = 0 where Schlick is not too large.  At least 0: a and lambda of one n and k
/// may take more from an R_0 than there is.
inline float fresnel_corrected_schlick(float c, float f0, float a, float lambda) {
    const float F = fresnel_schlick(c, f0) - a * c * raster::pow(1.0f - c, lambda);
    return F > 0.0f ? F : 0.0f;
}

/// Corrected Schlick as the thesis prints it   F = F_14 - a (1 - c)^lambda,   a = 2 n                      eq. (15)
/// The factor c is lost: F(90 degrees) = 1 - 2 n, below 0 for most metals. Here for comparison; pictures take 0 there.
inline float fresnel_corrected_schlick_as_printed(float c, float f0, float a, float lambda) {
    return fresnel_schlick(c, f0) - a * raster::pow(1.0f - c, lambda);
}

/// F82   F = F_Schlick - b c (1 - c)^6     b makes F exact at c = 1/7, 81.8 degrees: see f82_coefficient().
/// Hoffman 2019, "Fresnel equations considered harmful"; Kutz, Hasan & Edmondson 2021. For metals: a dielectric gets
/// worse.  Kept in [0, 1] (or R_0 where that is above 1): a free choice of F(1/7) may leave it elsewhere.
inline float fresnel_f82(float c, float f0, float b) {
    const float x = 1.0f - c;
    const float F = fresnel_schlick(c, f0) - b * c * (schlick_weight(c) * x);
    const float at_least_0 = F > 0.0f ? F : 0.0f;
    return raster::smaller_of_positive(at_least_0, f0 > 1.0f ? f0 : 1.0f);
}

/// b of F82 from the value wanted at c = 1/7   b = (F_Schlick(1/7) - F(1/7)) / (1/7 (6/7)^6)
inline float f82_coefficient(float f0, float f82) {
    constexpr float kOneByPeak = 17.6513846f;  // 7^7 / 6^6
    return (fresnel_schlick(1.0f / 7.0f, f0) - f82) * kOneByPeak;
}

/// The empirical form of NVIDIA's Cg tutorial   F = max(0, min(1, bias + scale (1 + I.N)^power))            eq. (6)
/// I is the way the light travels, so 1 + I.N = 1 - c.  power > 0.
inline float fresnel_nvidia(float c, float bias, float scale, float power) {
    return raster::saturate(bias + scale * raster::pow(1.0f - c, power));
}

// -------------------------------------------------------------------------------------------------- tables

/// Look-up with linear interpolation in c   F(c) ~ (1 - t) F_i + t F_(i+1)                            section 3.3
/// values[i] = F at c = i / (size - 1), size >= 2: samples at both ends, because F is steepest at c = 0.
/// (A texture of a GPU has them at (i + 1/2) / size and is 10 % off at 90 degrees with 16 texels.)
inline float fresnel_lookup(float c, const float* values, int size) {
    const float x = raster::saturate(c) * static_cast<float>(size - 1);
    const int truncated = static_cast<int>(x);
    const int i = truncated < size - 2 ? truncated : size - 2;
    return raster::lerp(values[i], values[i + 1], x - static_cast<float>(i));
}

/// F at c in [0, 1], linear between the entries of the table.
inline glm::vec3 fresnel_lookup(float c, const FresnelTable& table) {
    const int size = table.size();
    return {fresnel_lookup(c, table.r.data(), size), fresnel_lookup(c, table.g.data(), size),
            fresnel_lookup(c, table.b.data(), size)};
}

// ------------------------------------------------------------------------------------------ three channels

/// The same a channel.
inline glm::vec3 fresnel_dielectric(float c, const glm::vec3& n) {
    return {fresnel_dielectric(c, n.x), fresnel_dielectric(c, n.y), fresnel_dielectric(c, n.z)};
}

/// The same a channel.
inline glm::vec3 fresnel_conductor(float c, const glm::vec3& n, const glm::vec3& k) {
    return {fresnel_conductor(c, n.x, k.x), fresnel_conductor(c, n.y, k.y), fresnel_conductor(c, n.z, k.z)};
}

/// The same a channel.
inline glm::vec3 f0_from_index(const glm::vec3& n, const glm::vec3& k) {
    return {f0_from_index(n.x, k.x), f0_from_index(n.y, k.y), f0_from_index(n.z, k.z)};
}

/// The same a channel.
inline glm::vec3 index_from_f0(const glm::vec3& f0) {
    return {index_from_f0(f0.x), index_from_f0(f0.y), index_from_f0(f0.z)};
}

/// The same a channel.
inline glm::vec3 fresnel_schlick(float c, const glm::vec3& f0) {
    return f0 + (1.0f - f0) * schlick_weight(c);
}

/// The same a channel.
inline glm::vec3 fresnel_schlick_between(float c, const glm::vec3& n) {
    return {fresnel_schlick_between(c, n.x), fresnel_schlick_between(c, n.y), fresnel_schlick_between(c, n.z)};
}

/// The same a channel.
inline glm::vec3 fresnel_rescaled_schlick(float c, const glm::vec3& n, const glm::vec3& k) {
    return {fresnel_rescaled_schlick(c, n.x, k.x), fresnel_rescaled_schlick(c, n.y, k.y),
            fresnel_rescaled_schlick(c, n.z, k.z)};
}

/// The same a channel.
inline glm::vec3 fresnel_corrected_schlick(float c, const glm::vec3& f0, const glm::vec3& a, const glm::vec3& lambda) {
    return {fresnel_corrected_schlick(c, f0.x, a.x, lambda.x), fresnel_corrected_schlick(c, f0.y, a.y, lambda.y),
            fresnel_corrected_schlick(c, f0.z, a.z, lambda.z)};
}

/// The same a channel.
inline glm::vec3 fresnel_corrected_schlick_as_printed(float c, const glm::vec3& f0, const glm::vec3& a,
                                                      const glm::vec3& lambda) {
    return {fresnel_corrected_schlick_as_printed(c, f0.x, a.x, lambda.x),
            fresnel_corrected_schlick_as_printed(c, f0.y, a.y, lambda.y),
            fresnel_corrected_schlick_as_printed(c, f0.z, a.z, lambda.z)};
}

/// The same a channel.
inline glm::vec3 fresnel_f82(float c, const glm::vec3& f0, const glm::vec3& b) {
    return {fresnel_f82(c, f0.x, b.x), fresnel_f82(c, f0.y, b.y), fresnel_f82(c, f0.z, b.z)};
}

/// The same a channel.
inline glm::vec3 fresnel_nvidia(float c, const glm::vec3& bias, const glm::vec3& scale, float power) {
    return {fresnel_nvidia(c, bias.x, scale.x, power), fresnel_nvidia(c, bias.y, scale.y, power),
            fresnel_nvidia(c, bias.z, scale.z, power)};
}

// ---------------------------------------------------------------------- set-up: once a material, see fresnel.cpp

/// Where the correction of Schlick is made exact: the two ends of the bracket of Lazanyi & Szirmay-Kalos 2005.
inline constexpr float kCorrectionCosine = 0.15f;           ///< 81.37 degrees: reproduces the thesis' table 2
inline constexpr float kCorrectionCosineAsPrinted = 0.10f;  ///< 84.26 degrees: the end its text names

/// a and lambda of one channel of fresnel_corrected_schlick.
struct SchlickCorrection {
    float a = 0.0f;       ///< 2 n, or 0: no correction where Schlick is not above the exact value
    float lambda = 1.0f;  ///< the exponent of (1 - cos theta) in the correction
};

/// lambda = ln(delta / (a c_m)) / ln(1 - c_m),   delta = F_14(c_m) - F(c_m)
[[nodiscard]] SchlickCorrection fit_correction(float n, float k, float c_m = kCorrectionCosine);

/// The same for the form without the factor c   lambda = ln(delta / a) / ln(1 - c_m)
[[nodiscard]] SchlickCorrection fit_correction_as_printed(float n, float k, float c_m = kCorrectionCosineAsPrinted);

/// b of fresnel_f82 for a metal of known n and k, each channel.
[[nodiscard]] glm::vec3 f82_coefficient_from_index(const glm::vec3& n, const glm::vec3& k);

/// F of three channels by c = cos theta.
using FresnelFunction = std::function<glm::vec3(float)>;

/// Any F at size >= 2 cosines.
[[nodiscard]] FresnelTable tabulate(const FresnelFunction& fresnel, int size);

/// The exact F of n + i k at size >= 2 cosines.
[[nodiscard]] FresnelTable fresnel_table(const glm::vec3& n, const glm::vec3& k, int size = 256);

}  // namespace kreda::lighting
