// The empirical models, symbol by symbol: the functions of lighting/reflection.hpp and lighting/ward.hpp, one a line.
#include <cmath>

#include <glm/geometric.hpp>

#include "lighting/batch/passes.hpp"
#include "lighting/reflect.hpp"
#include "lighting/reflection.hpp"
#include "lighting/ward.hpp"
#include "tools/explain/explain_light.hpp"

namespace kreda::tools {

using lighting::ReflectedTerms;

namespace {

using lighting::PhongMaterial;
using lighting::ReflectionModel;

struct Directions {
    glm::vec3 n, l, v;
    glm::vec3 t;  ///< only where the model has a grain
};

std::string positive_text(const glm::vec3& a, const glm::vec3& b) {
    return "max(" + dot_text(a, b) + ", 0)";
}

void explain_diffuse(const Directions& d, const PhongMaterial& m, const glm::vec3& result, Section& section) {
    const float n_dot_l = lighting::positive_dot(d.n, d.l);
    section.equation("n·l", "max(n·l, 0)", positive_text(d.n, d.l), n_dot_l,
                     glm::dot(d.n, d.l) > 0.0f ? "" : "the surface faces away from this light");
    section.equation("f_D", "m_D (n·l)", vector_text(m.diffuse) + " · " + number_text(n_dot_l), result);
}

/// m_S Sigma^h, and 0 for a surface that faces away.
void explain_highlight(const Directions& d, const PhongMaterial& m, float sigma, const glm::vec3& result,
                       Section& section) {
    const float power = raster::pow(sigma, m.shininess);
    section.equation("Σʰ", "Σ^h", number_text(sigma) + "^" + number_text(m.shininess), power);
    const bool faces = lighting::faces_light(glm::dot(d.n, d.l)) > 0.0f;
    section.equation("f_S", faces ? "m_S Σʰ" : "0", faces ? vector_text(m.specular) + " · " + number_text(power) : "",
                     result, faces ? "" : "n·l <= 0: no highlight on the dark side");
}

void explain_phong(const Directions& d, const PhongMaterial& m, const ReflectedTerms& terms, Section& section) {
    explain_diffuse(d, m, terms.diffuse, section);
    const glm::vec3 r = lighting::mirror_vector(d.n, d.l);
    section.equation("r", "2 (n·l) n - l",
                     "2·" + factor_text(glm::dot(d.n, d.l)) + "·" + vector_text(d.n) + " - " + vector_text(d.l), r,
                     "l mirrored in n");
    const float sigma = lighting::sigma_phong(d.v, r);
    section.equation("Σ", "max(v·r, 0)", positive_text(d.v, r), sigma);
    explain_highlight(d, m, sigma, terms.specular, section);
}

void explain_blinn(const Directions& d, const PhongMaterial& m, const ReflectedTerms& terms, Section& section) {
    explain_diffuse(d, m, terms.diffuse, section);
    const glm::vec3 h = lighting::half_vector(d.l, d.v);
    section.equation("h", "(l + v) / |l + v|", vector_text(d.l + d.v) + " / " + number_text(glm::length(d.l + d.v)), h,
                     "half way between light and viewer");
    const float sigma = lighting::sigma_blinn(d.n, h);
    section.equation("Σ", "max(n·h, 0)", positive_text(d.n, h), sigma);
    explain_highlight(d, m, sigma, terms.specular, section);
}

void explain_lambert(const Directions& d, const PhongMaterial& m, const ReflectedTerms& terms, Section& section) {
    explain_diffuse(d, m, terms.diffuse, section);
    section.equation("f_S", "", "", terms.specular, "Lambert's surface has no highlight");
}

void explain_lobe(const PhongMaterial& m, const char* formula, float f, float n_dot_l, const glm::vec3& result,
                  Section& section) {
    section.equation("f", formula, "", f, "1/sr");
    section.equation("f_S", "m_S π f (n·l)",
                     vector_text(m.specular) + " · π · " + number_text(f) + " · " + number_text(n_dot_l), result);
}

void explain_ward(const Directions& d, const PhongMaterial& m, const ReflectedTerms& terms, Section& section) {
    const lighting::MicrofacetAngles a = lighting::microfacet_angles(d.n, d.l, d.v);
    explain_diffuse(d, m, terms.diffuse, section);
    const float alpha = lighting::ward_alpha_from_shininess(m.shininess);
    section.equation("α", "√(2 / (shininess + 2))", "√(2 / (" + number_text(m.shininess) + " + 2))", alpha,
                     "width of the lobe");
    section.equation("n·v", "max(n·v, 0)", positive_text(d.n, d.v), a.n_dot_v);
    section.equation("n·h", "max(n·h, 0)", "", a.n_dot_h);
    section.equation("tan²θ_h", "sin²θ_h / (n·h)²", number_text(a.sin2_h) + " / " + number_text(a.n_dot_h) + "²",
                     a.sin2_h / (a.n_dot_h * a.n_dot_h));
    explain_lobe(m, "exp(-tan²θ_h / α²) / (4π α² √((n·l)(n·v)))", lighting::ward_isotropic(a, alpha), a.n_dot_l,
                 terms.specular, section);
}

/// Ward's lobe with one width along the grain and another across.
void explain_brushed(const Directions& d, const PhongMaterial& m, const ReflectedTerms& terms, Section& section) {
    const glm::vec2 alpha = *m.ward_alpha;
    explain_diffuse(d, m, terms.diffuse, section);
    const glm::vec3 h = lighting::half_vector(d.l, d.v);
    const glm::vec3 b = glm::cross(d.n, d.t);
    section.equation("t", "", "", d.t, "along the grain");
    section.equation("b", "n × t", "", b, "across it");
    section.equation("h", "(l + v) / |l + v|", vector_text(d.l + d.v) + " / " + number_text(glm::length(d.l + d.v)), h);
    section.equation("h·t", "", dot_text(h, d.t), glm::dot(h, d.t));
    section.equation("h·b", "", dot_text(h, b), glm::dot(h, b));
    section.equation("h·n", "", dot_text(h, d.n), glm::dot(h, d.n));
    section.equation("e", "((h·t / α_t)² + (h·b / α_b)²) / (h·n)²",
                     "((" + number_text(glm::dot(h, d.t)) + " / " + number_text(alpha.x) + ")² + (" +
                         number_text(glm::dot(h, b)) + " / " + number_text(alpha.y) + ")²) / " +
                         factor_text(glm::dot(h, d.n)) + "²",
                     lighting::ward_exponent(h, d.n, d.t, b, alpha.x, alpha.y));
    explain_lobe(m, "exp(-e) / (4π α_t α_b √((n·l)(n·v)))",
                 lighting::ward_anisotropic(d.n, d.t, b, d.l, d.v, alpha.x, alpha.y), lighting::positive_dot(d.n, d.l),
                 terms.specular, section);
}

void explain_threads(const Directions& d, const PhongMaterial& m, const ReflectedTerms& terms, Section& section) {
    const float l_dot_t = glm::dot(d.l, d.t), v_dot_t = glm::dot(d.v, d.t);
    const float sin_l = lighting::sine_from_cosine(l_dot_t), sin_v = lighting::sine_from_cosine(v_dot_t);
    const float n_dot_l = lighting::positive_dot(d.n, d.l);
    const float mirror = raster::saturate(sin_l * sin_v - l_dot_t * v_dot_t);
    section.equation("n·l", "max(n·l, 0)", positive_text(d.n, d.l), n_dot_l);
    section.equation("t", "", "", d.t, "along the threads");
    section.equation("l·t", "", dot_text(d.l, d.t), l_dot_t);
    section.equation("v·t", "", dot_text(d.v, d.t), v_dot_t);
    section.equation("f_D", "m_D √(1 - (l·t)²) (n·l)",
                     vector_text(m.diffuse) + " · " + number_text(sin_l) + " · " + number_text(n_dot_l), terms.diffuse);
    section.equation(
        "Σ", "max(√(1 - (l·t)²) √(1 - (v·t)²) - (l·t)(v·t), 0)",
        number_text(sin_l) + "·" + number_text(sin_v) + " - " + factor_text(l_dot_t) + "·" + factor_text(v_dot_t),
        mirror);
    section.equation("f_S", "m_S Σ^h (n·l)",
                     vector_text(m.specular) + " · " + number_text(mirror) + "^" + number_text(m.shininess) + " · " +
                         number_text(n_dot_l),
                     terms.specular);
}

}  // namespace

ReflectedTerms explain_reflection(const lighting::MaterialSetup& setup, const lighting::LightingChannels& after,
                                  Section& section) {
    const Directions d{after.n.at(0), after.l.at(0), after.v.at(0), after.t.at(0)};
    const lighting::PointMaterial material = material_at(setup, after, 0);
    const ReflectedTerms terms = lighting::reflect(material, d.n, d.l, d.v);
    const PhongMaterial& m = material.phong;
    switch (material.model) {
        case ReflectionModel::unlit: break;
        case ReflectionModel::lambert: explain_lambert(d, m, terms, section); break;
        case ReflectionModel::phong: explain_phong(d, m, terms, section); break;
        case ReflectionModel::blinn_phong: explain_blinn(d, m, terms, section); break;
        case ReflectionModel::ward:
            m.ward_alpha ? explain_brushed(d, m, terms, section) : explain_ward(d, m, terms, section);
            break;
        case ReflectionModel::heidrich_seidel: explain_threads(d, m, terms, section); break;
        case ReflectionModel::cook_torrance: explain_microfacets(setup.cook_torrance, after, terms, section); break;
    }
    return terms;
}

}  // namespace kreda::tools
