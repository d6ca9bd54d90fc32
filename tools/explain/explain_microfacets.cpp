// The microfacet model, symbol by symbol: D, V, F and what they make together. The letters are
// lighting/microfacet.hpp's.
#include <cmath>

#include <glm/geometric.hpp>

#include "lighting/batch/microfacet_passes.hpp"
#include "lighting/microfacet_choices.hpp"
#include "tools/explain/explain_light.hpp"

namespace kreda::tools {

namespace {

using lighting::CookTorranceSetup;
using lighting::Distribution;
using lighting::EnergyCompensation;
using lighting::FresnelMethod;
using lighting::Geometry;
using lighting::MicrofacetChannels;

std::string text(float value) {
    return number_text(value);
}

/// α² / (π (...)²) with its numbers; the other distributions give their result alone.
std::string distribution_numbers(Distribution distribution, const MicrofacetChannels& m) {
    const std::string alpha = text(m.surface.at(0).alpha);
    const std::string n_dot_h = text(m.n_dot_h.at(0));
    const std::string sin2 = text(m.sin2_h.at(0));
    switch (distribution) {
        case Distribution::ggx: return alpha + "² / (π (" + sin2 + " + " + n_dot_h + "²·" + alpha + "²)²)";
        case Distribution::beckmann:
            return "exp(-" + sin2 + " / " + n_dot_h + "² / " + alpha + "²) / (π " + alpha + "² " + n_dot_h + "⁴)";
        default: return "";
    }
}

std::string visibility_numbers(Geometry geometry, const MicrofacetChannels& m) {
    if (geometry != Geometry::schlick_ggx) return "";
    const std::string k = text(lighting::schlick_k_direct(m.surface.at(0).roughness));
    const std::string rest = "(1-" + k + ") + " + k + ")";
    return "1 / (4 (" + text(m.n_dot_l.at(0)) + rest + " (" + text(m.n_dot_v.at(0)) + rest + ")";
}

void explain_surface(const CookTorranceSetup& setup, const MicrofacetChannels& m, Section& section) {
    section.equation("c", "", "", m.surface.at(0).albedo, "albedo");
    section.equation("α", "roughness²", text(m.surface.at(0).roughness) + "²", m.surface.at(0).alpha);
    if (setup.all_wavelengths) {
        section.equation("F0", "Σ over wavelengths", "", m.surface.at(0).f0,
                         "measured n and k, through the eye's three curves");
        return;
    }
    if (setup.has_index) {
        section.equation("F0", "((n-1)² + k²) / ((n+1)² + k²)", "", m.surface.at(0).f0,
                         "n " + vector_text(setup.n) + ", k " + vector_text(setup.k));
        return;
    }
    const float metallic = m.surface.at(0).metallic;
    section.equation(
        "F0", "0.04 (1 - metallic) + c metallic",
        "0.04·" + text(1.0f - metallic) + " + " + vector_text(m.surface.at(0).albedo) + "·" + text(metallic),
        m.surface.at(0).f0);
}

void explain_angles(const lighting::LightingChannels& after, Section& section) {
    const MicrofacetChannels& m = after.microfacet;
    const glm::vec3 n = after.n.at(0), l = after.l.at(0), v = after.v.at(0);
    const glm::vec3 sum = l + v;
    section.equation("h", "(l + v) / |l + v|", vector_text(sum) + " / " + text(glm::length(sum)),
                     sum / glm::length(sum));
    section.equation("n·l", "max(n·l, 0)", "max(" + dot_text(n, l) + ", 0)", m.n_dot_l.at(0),
                     glm::dot(n, l) > 0.0f ? "" : "the surface faces away from this light");
    section.equation("n·v", "max(n·v, 0)", "max(" + dot_text(n, v) + ", 0)", m.n_dot_v.at(0));
    section.equation("n·h", "max(n·h, 0)", "", m.n_dot_h.at(0));
    section.equation("v·h", "|l + v| / 2", text(glm::length(sum)) + " / 2", m.v_dot_h.at(0), "= l·h");
    section.equation("sin²θ_h", "d (1 - d/4),  d = |n - h|²", "", m.sin2_h.at(0), "= 1 - (n·h)², without cancelling");
}

void explain_D_V_F(const CookTorranceSetup& setup, const MicrofacetChannels& m, Section& section) {
    const lighting::FormulaFacts& D = facts_of(setup.distribution);
    const lighting::FormulaFacts& V = facts_of(setup.geometry);
    const lighting::FormulaFacts F = fresnel_facts(setup);
    section.equation("D", std::string(D.text), distribution_numbers(setup.distribution, m), m.D.at(0),
                     std::string("[1/sr] ") + std::string(D.name) + ": share of microfacets that face h");
    section.equation("V", std::string(V.text), visibility_numbers(setup.geometry, m), m.V.at(0),
                     std::string(V.name) + ": G / (4 (n·l)(n·v))");
    section.equation("G", "4 V (n·l)(n·v)", "", 4.0f * m.V.at(0) * m.n_dot_l.at(0) * m.n_dot_v.at(0),
                     "share of them that light and viewer both see");
    const bool schlick = setup.fresnel == FresnelMethod::schlick || setup.fresnel == FresnelMethod::rescaled_schlick;
    const std::string f0 = vector_text(m.surface.at(0).f0);
    section.equation("F", std::string(F.text),
                     schlick ? f0 + " + (1 - " + f0 + ")(1 - " + text(m.v_dot_h.at(0)) + ")⁵" : "", m.F.at(0),
                     std::string(F.name) + ": share of the light that is reflected");
}

}  // namespace

void explain_microfacets(const CookTorranceSetup& setup, const lighting::LightingChannels& after,
                         const lighting::ReflectedTerms& terms, Section& section) {
    const MicrofacetChannels& m = after.microfacet;
    explain_surface(setup, m, section);
    explain_angles(after, section);
    explain_D_V_F(setup, m, section);
    const lighting::ReflectedTerms once = lighting::combine_terms(m.n_dot_l.at(0), m.D.at(0), m.V.at(0), m.F.at(0),
                                                                  m.surface.at(0).albedo, m.surface.at(0).metallic);
    const glm::vec3 transmitted = glm::clamp(1.0f - m.F.at(0), 0.0f, 1.0f);
    section.equation(
        "k_d", "(1 - F)(1 - metallic)", vector_text(transmitted) + " · " + text(1.0f - m.surface.at(0).metallic),
        lighting::diffuse_share(m.F.at(0), m.surface.at(0).metallic), "what enters the surface and comes out again");
    section.equation("f_D", "k_d c / π · (n·l)", "", once.diffuse);
    section.equation(
        "f_S", "D V F (n·l)",
        text(m.D.at(0)) + " · " + text(m.V.at(0)) + " · " + vector_text(m.F.at(0)) + " · " + text(m.n_dot_l.at(0)),
        once.specular);
    if (setup.energy_compensation == EnergyCompensation::none) return;

    const glm::vec3 further = compensation_term(setup, m.surface.at(0), m.n_dot_l.at(0), m.n_dot_v.at(0));
    section.equation("f_ms", "F_ms (1 - E(n·l))(1 - E(n·v)) / (π (1 - E_avg)) · (n·l)", "", further,
                     "Kulla and Conty: light that leaves after several bounces");
    section.equation("f_S", "f_S + f_ms", vector_text(once.specular) + " + " + vector_text(further), terms.specular);
}

}  // namespace kreda::tools
