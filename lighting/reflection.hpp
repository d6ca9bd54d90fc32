// The empirical local models: Lambert, Phong with the mirror vector, Blinn-Phong with the half vector.
// Sources: Strachota 2020, "Osvetlovani a stinovani", section 3; Sajko, "Lokalni modeli osvjetljenja".
//
// At a point of a surface all unit vectors point away from it: n the normal, l to the light, v to the viewer.
//   I = s_A m_A + m_E + sum over lights  s (m_D (l.n) + m_S Sigma(l, n, v)^h)
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "lighting/material.hpp"
#include "raster/scalar_math.hpp"
#include "raster/unit_vector.hpp"

namespace kreda::lighting {

/// What one light adds, before its colour: m_D (l.n) and m_S Sigma^h.
struct ReflectedTerms {
    glm::vec3 diffuse{0.0f};   ///< m_D (l.n), linear RGB
    glm::vec3 specular{0.0f};  ///< m_S Sigma^h, linear RGB
};

/// max(a . b, 0)
inline float positive_dot(const glm::vec3& a, const glm::vec3& b) {
    const float cosine = glm::dot(a, b);
    return cosine > 0.0f ? cosine : 0.0f;
}

using raster::unit;

/// Ambient term   I_A = s_A (x) m_A, component by component.
inline glm::vec3 ambient_term(const glm::vec3& s_A, const glm::vec3& m_A) {
    return s_A * m_A;
}

/// Mirror image of l in the normal   r = 2 (n.l) n - l.   Unit to 1e-6 if n and l are. The same of v in a facet h.
inline glm::vec3 mirror_vector(const glm::vec3& n, const glm::vec3& l, float n_dot_l) {
    return 2.0f * n_dot_l * n - l;
}
/// The same where n.l is not at hand yet.
inline glm::vec3 mirror_vector(const glm::vec3& n, const glm::vec3& l) {
    return mirror_vector(n, l, glm::dot(n, l));
}

/// Half vector   h = (l + v) / |l + v|.   l = -v has none: the result is 0.
inline glm::vec3 half_vector(const glm::vec3& l, const glm::vec3& v) {
    return unit(l + v);
}

/// Phong's measure of reflection   Sigma = max(v.r, 0) = max(cos rho, 0)                  Phong 1975
/// In [0, 1]: two unit vectors in float may have a product above 1 by 3e-7, and to the power of 10^6 that is 1.3.
inline float sigma_phong(const glm::vec3& v, const glm::vec3& r) {
    return raster::saturate(glm::dot(v, r));
}

/// Blinn's measure of reflection   Sigma = max(n.h, 0) = max(cos theta, 0)                Blinn 1977
/// In [0, 1], as Phong's.
inline float sigma_blinn(const glm::vec3& n, const glm::vec3& h) {
    return raster::saturate(glm::dot(n, h));
}

/// The exponent that gives Blinn's highlight the width of Phong's. theta is half of rho where n, l, v lie in one plane,
/// and cos^h rho = cos^h' (rho / 2) makes h' / h tend to 4. True near normal incidence only.    Fisher & Woo 1994
inline float blinn_exponent_matching_phong(float shininess) {
    return 4.0f * shininess;
}

/// Lambert's law   m_D max(l.n, 0)
inline ReflectedTerms lambert(const glm::vec3& n, const glm::vec3& l, const PhongMaterial& m) {
    const float n_dot_l = positive_dot(n, l);
    return {m.diffuse * n_dot_l, glm::vec3(0.0f)};
}

/// A surface that faces away from the light reflects nothing of it: 1 where n.l > 0, else 0.
inline float faces_light(float n_dot_l) {
    return n_dot_l > 0.0f ? 1.0f : 0.0f;
}

/// What one light adds where n.l (of either sign) and the highlight are known   m_D max(n.l, 0),   m_S highlight
inline ReflectedTerms phong_terms(float n_dot_l, float highlight, const PhongMaterial& m) {
    const float cosine = n_dot_l > 0.0f ? n_dot_l : 0.0f;
    return {m.diffuse * cosine, m.specular * highlight};
}

/// The highlight   Sigma^h, 0 on the side that faces away from the light.  Sigma in [0, 1], h in [0, 1e9]; in [0, 1].
inline float highlight_of(float sigma, float n_dot_l, const PhongMaterial& m) {
    return raster::pow(sigma, m.shininess) * faces_light(n_dot_l);
}

// phong() and blinn_phong() are the whole formulas at one point; they differ in Sigma. A large batch runs the same
// small functions as passes, each leaving a channel: n.l; Sigma; the highlight; the terms.

/// Phong's model of one light, mirror vector:   m_D (l.n),   m_S (v.r)^h      n, l, v unit, h in [0, 1e9]
inline ReflectedTerms phong(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const PhongMaterial& m) {
    const float n_dot_l = glm::dot(n, l);
    const glm::vec3 r = mirror_vector(n, l, n_dot_l);
    const float sigma = sigma_phong(v, r);
    const float highlight = highlight_of(sigma, n_dot_l, m);
    return phong_terms(n_dot_l, highlight, m);
}

/// Blinn-Phong model of one light, half vector:   m_D (l.n),   m_S (n.h)^h      n, l, v unit, h in [0, 1e9]
inline ReflectedTerms blinn_phong(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const PhongMaterial& m) {
    const float n_dot_l = glm::dot(n, l);
    const glm::vec3 h = half_vector(l, v);
    const float sigma = sigma_blinn(n, h);
    const float highlight = highlight_of(sigma, n_dot_l, m);
    return phong_terms(n_dot_l, highlight, m);
}

}  // namespace kreda::lighting
