// Microfacets: how many of them face the half vector (D) and how many of those light and viewer both see (G, V).
// Sources: Gelemanovic 2018, section 2.2 ("the thesis"); Walter et al. 2007; Heitz 2014. The letters are theirs.
//
// A D takes n.h and sin^2 of the angle between n and h, computed so that it does not cancel: next to a highlight
// 1 - (n.h)^2 has no correct digit left in float, which makes a GGX highlight of roughness 0.1 wrong by 1 %.
// A V is G / (4 (n.l)(n.v)), already cancelled: finite where n.l or n.v is 0.
// Every function is one formula without a branch.
#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "raster/scalar_math.hpp"
#include "raster/unit_vector.hpp"

namespace kreda::lighting {

/// A highlight of smaller alpha is narrower than a pixel; it would glitter. roughness 0.045            Filament
inline constexpr float kMinAlpha = 0.002025f;

/// alpha = roughness^2, in [kMinAlpha, 1].                                  Burley 2012, Gelemanovic 2018 section 2.2.1
inline float alpha_from_roughness(float roughness) {
    const float alpha = roughness * roughness;
    return alpha > kMinAlpha ? (alpha < 1.0f ? alpha : 1.0f) : kMinAlpha;
}

/// The angles of a microfacet model at one point. All cosines are in [0, 1]: negative ones count as 0.
struct MicrofacetAngles {
    float n_dot_l;  ///< how slantwise the light arrives
    float n_dot_v;  ///< how slantwise it is seen
    float n_dot_h;  ///< 1: the facets that mirror l into v lie flat
    float v_dot_h;  ///< = l.h
    float sin2_h;   ///< 1 - (n.h)^2
};

/// sin^2 in [0, 1] of the angle of unit vectors   sin^2 theta = d (1 - d/4),   d = |a - b|^2 = 4 sin^2(theta / 2)
/// The difference of near floats is exact, so this has all its digits where 1 - (a.b)^2 has none.
inline float squared_sine(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 difference = a - b;
    const float d = glm::dot(difference, difference);
    return raster::saturate(d * (1.0f - 0.25f * d));
}

/// Those of them that concern the half vector.
struct HalfVectorAngles {
    float n_dot_h;  ///< in [0, 1]
    float v_dot_h;  ///< = l.h, in [0, 1]
    float sin2_h;   ///< 1 - (n.h)^2, in [0, 1]
};

/// n, l, v unit.   h = (l + v) / |l + v|,   v.h = |l + v| / 2   (the same bits for l and v exchanged).
/// l = -v has no h: v.h = 0 there, and one of n.l, n.v is 0.
/// l and v rounded to float turn h by some 6e-8 / (v.h): in D a relative error of up to 5e-7 / (alpha v.h).
inline HalfVectorAngles half_vector_angles(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v) {
    const glm::vec3 sum = l + v;
    const float length = raster::divisible_length(sum);
    const glm::vec3 h = sum * (1.0f / length);  // unit(sum)
    return {raster::saturate(glm::dot(n, h)), raster::saturate(0.5f * length), squared_sine(n, h)};
}

/// All of them; n, l, v unit.
inline MicrofacetAngles microfacet_angles(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v) {
    const HalfVectorAngles half = half_vector_angles(n, l, v);
    return {raster::saturate(glm::dot(n, l)), raster::saturate(glm::dot(n, v)), half.n_dot_h, half.v_dot_h,
            half.sin2_h};
}

// ----------------------------------------------------------------------------- D   [1/sr]   int D (n.h) dh = 1

/// GGX (Trowbridge & Reitz 1975)   D = alpha^2 / (pi ((n.h)^2 (alpha^2 - 1) + 1)^2)
/// Walter et al. 2007 eq. (33); thesis eq. (5). The bracket is q = sin^2 + (n.h)^2 alpha^2: two positive terms.
inline float ggx_distribution(float n_dot_h, float sin2_h, float alpha) {
    const float c_alpha = n_dot_h * alpha;
    const float q = sin2_h + c_alpha * c_alpha;
    const float alpha_by_q = alpha / (q > 1e-18f ? q : 1e-18f);
    return alpha_by_q * alpha_by_q * raster::kInvPi;
}

/// The exponent of Beckmann's lobe and of Ward's   -tan^2 theta_h / alpha^2, at most 0.   alpha in [0.002, 1]
inline float beckmann_exponent(float n_dot_h, float sin2_h, float alpha) {
    const float c2 = n_dot_h * n_dot_h > 1e-12f ? n_dot_h * n_dot_h : 1e-12f;
    return -sin2_h / (c2 * (alpha * alpha));
}

/// Beckmann   D = exp(-tan^2 theta_h / alpha^2) / (pi alpha^2 cos^4 theta_h)
/// Cook & Torrance 1982; Walter et al. 2007 eq. (25)
inline float beckmann_distribution(float n_dot_h, float sin2_h, float alpha) {
    const float c2 = n_dot_h * n_dot_h > 1e-12f ? n_dot_h * n_dot_h : 1e-12f;
    const float exponent = beckmann_exponent(n_dot_h, sin2_h, alpha);
    return raster::exp(exponent) / (raster::kPi * (alpha * alpha) * (c2 * c2));
}

/// ln(1 - x) given both x and 1 - x, relative error below 1e-6 on all of [0, 1]: near 0 as -2 artanh(x / (2 - x)), a
/// series in x alone.
inline float log_one_minus(float x, float one_minus_x) {
    constexpr float kLn2 = 0.693147181f;
    const float y = x / (2.0f - x);
    const float y2 = y * y;
    const float series = 1.0f + y2 * (1.0f / 3.0f + y2 * (1.0f / 5.0f + y2 * (1.0f / 7.0f + y2 * (1.0f / 9.0f))));
    const float near_zero = -2.0f * y * series;
    const float elsewhere = kLn2 * raster::log2(one_minus_x > 1e-30f ? one_minus_x : 1e-30f);
    return x < 0.25f ? near_zero : elsewhere;
}

/// Blinn-Phong as a distribution   D = (n + 2) / (2 pi) (n.h)^n,   n = 2 / alpha^2 - 2
/// Blinn 1977; Walter et al. 2007 eq. (30)
inline float blinn_phong_distribution(float n_dot_h, float sin2_h, float alpha) {
    const float two_by_alpha2 = 2.0f / (alpha * alpha);                        // n + 2
    const float exponent = two_by_alpha2 * ((1.0f - alpha) * (1.0f + alpha));  // n
    const float power = raster::exp(0.5f * exponent * log_one_minus(sin2_h, n_dot_h * n_dot_h));
    return 0.5f * raster::kInvPi * two_by_alpha2 * power;
}

/// theta^2 of an angle in [0, 90] degrees from its cosine and sin^2, without an arcsine:
/// theta^2 = 4 arcsin^2(sqrt(d) / 2) = d + d^2/12 + d^3/90 + ...,   d = |n - h|^2 = 2 sin^2 / (1 + cos).
/// The polynomial goes through the Chebyshev points of [0, 2]; its error is 1e-9.
inline float squared_angle(float cosine, float sin2) {
    const float d = 2.0f * sin2 / (1.0f + cosine);
    float p = 1.61748917e-6f;
    p = p * d - 8.87777198e-6f;
    p = p * d + 2.90698927e-5f;
    p = p * d - 3.05150658e-5f;
    p = p * d + 1.00310724e-4f;
    p = p * d + 2.94823035e-4f;
    p = p * d + 1.79292012e-3f;
    p = p * d + 1.11099606e-2f;
    p = p * d + 8.33334039e-2f;
    return d * (1.0f + d * p);
}

/// 1 / c of the Gaussian:  int exp(-(theta/m)^2) cos theta dw over the hemisphere, m in (0, 1].
/// It has no elementary form (pi m^2 is 18 % too large at m = 0.5): pi m^2 times a polynomial in m^2 through the
/// Chebyshev points of [0, 1], error 2.3e-6.
inline float gaussian_normalizer(float m) {
    const float m2 = m * m;
    float p = -0.152256935f;
    p = p * m2 + 0.641407749f;
    p = p * m2 - 1.06396008f;
    p = p * m2 + 0.850856362f;
    p = p * m2 - 0.308433388f;
    p = p * m2 - 0.0145225205f;
    p = p * m2 + 0.261064822f;
    p = p * m2 - 0.666468068f;
    p = p * m2 + 0.999998789f;
    return raster::kPi * m2 * p;
}

/// Gaussian   D = c exp(-(theta_h / m)^2),   m = alpha                              Torrance & Sparrow 1967; Blinn 1977
inline float gaussian_distribution(float n_dot_h, float sin2_h, float alpha) {
    const float theta2 = squared_angle(n_dot_h, sin2_h);
    return raster::exp(-theta2 / (alpha * alpha)) / gaussian_normalizer(alpha);
}

// -------------------------------------------------------------------------- V = G / (4 (n.l)(n.v))   [1]

/// k of Schlick-GGX for lights that are points   k = (roughness + 1)^2 / 8, in [1/8, 1/2]   Karis 2013; thesis eq. (6)
/// It darkens smooth surfaces: at roughness 0.1 it loses 18 % of the light where Smith's G loses 0.04 %.
inline float schlick_k_direct(float roughness) {
    return (roughness + 1.0f) * (roughness + 1.0f) * 0.125f;
}

/// k of Schlick-GGX for light from an image   k = alpha / 2, alpha in [0.002, 1]                          Karis 2013
inline float schlick_k_image(float alpha) {
    return 0.5f * alpha;
}

/// One direction of Schlick-GGX   G_1 = c / (c (1 - k) + k)                    Schlick 1994; Karis 2013; thesis eq. (7)
/// c in [0, 1], k in [0.001, 1/2]; in [0, 1].
inline float schlick_ggx_g1(float c, float k) {
    const float below = c * (1.0f - k) + k;
    return raster::smaller_of_positive(c / (below > 1e-12f ? below : 1e-12f), 1.0f);
}

/// Schlick-GGX, both directions   V = 1 / (4 ((n.l)(1-k) + k) ((n.v)(1-k) + k))                  thesis eq. (8)
inline float schlick_ggx_visibility(float n_dot_l, float n_dot_v, float k) {
    const float below_l = n_dot_l * (1.0f - k) + k;
    const float below_v = n_dot_v * (1.0f - k) + k;
    const float below = below_l * below_v;
    return 0.25f / (below > 1e-12f ? below : 1e-12f);
}

/// sqrt(alpha^2 + (1 - alpha^2) c^2) = c sqrt(1 + alpha^2 tan^2): the root in Smith's G for GGX.  In [alpha, 1].
inline float smith_root(float c, float alpha) {
    const float alpha2 = alpha * alpha;
    return std::sqrt((c - alpha2 * c) * c + alpha2);
}

/// Smith's G_1 for GGX   G_1 = 2 c / (c + sqrt(alpha^2 + (1 - alpha^2) c^2))                Walter et al. 2007 eq. (34)
inline float smith_g1(float c, float alpha) {
    return 2.0f * c / (c + smith_root(c, alpha));
}

/// Smith, light and viewer independent: G = G_1(l) G_1(v)   V = 1 / ((n.l + root_l) (n.v + root_v))
/// Walter et al. 2007 eq. (23)
inline float smith_visibility(float n_dot_l, float n_dot_v, float alpha) {
    const float below_l = n_dot_l + smith_root(n_dot_l, alpha);
    const float below_v = n_dot_v + smith_root(n_dot_v, alpha);
    return 1.0f / (below_l * below_v);
}

/// Smith, height-correlated: high facets are seen by both   V = 1 / (2 (n.l root_v + n.v root_l))   Heitz 2014 eq. (99)
inline float smith_correlated_visibility(float n_dot_l, float n_dot_v, float alpha) {
    const float below = n_dot_l * smith_root(n_dot_v, alpha) + n_dot_v * smith_root(n_dot_l, alpha);
    return 0.5f / (below > 1e-12f ? below : 1e-12f);
}

/// "Implicit": G = (n.l)(n.v), so that nothing is left to compute   V = 1/4                                Hoffman 2013
inline float implicit_visibility() {
    return 0.25f;
}

/// Cook and Torrance's V-shaped grooves   G = min(1, 2 (n.h)(n.v) / (v.h), 2 (n.h)(n.l) / (v.h))   Cook & Torrance 1982
/// The smaller of the last two has the smaller cosine, so with m and M the smaller and larger of n.l, n.v
///   V = min(1 / (2 m), n.h / v.h) / (2 M)
inline float cook_torrance_visibility(float n_dot_l, float n_dot_v, float n_dot_h, float v_dot_h) {
    const float smaller = n_dot_l < n_dot_v ? n_dot_l : n_dot_v;
    const float larger = n_dot_l < n_dot_v ? n_dot_v : n_dot_l;
    const float open = 0.5f / (smaller > 1e-12f ? smaller : 1e-12f);
    const float blocked = n_dot_h / (v_dot_h > 1e-6f ? v_dot_h : 1e-6f);
    return (open < blocked ? open : blocked) * 0.5f / (larger > 1e-6f ? larger : 1e-6f);
}

}  // namespace kreda::lighting
