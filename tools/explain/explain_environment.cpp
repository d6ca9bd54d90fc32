// The environment's light at a point, symbol by symbol: the split sum, or the integral by samples.
#include "lighting/batch/microfacet_passes.hpp"
#include "lighting/cook_torrance.hpp"
#include "lighting/environment/prefilter.hpp"
#include "lighting/reflection.hpp"
#include "scene/render/background.hpp"
#include "tools/explain/explain.hpp"
#include "tools/explain/explain_light.hpp"

namespace kreda::tools {

namespace {

using lighting::EnvironmentChannels;
using lighting::LightingChannels;
using lighting::MicrofacetChannels;

void explain_irradiance(const LitPoint& point, const LightingChannels& c, Section& section) {
    const lighting::EnvironmentSetup& setup = point.frame.lighting.environment;
    const glm::vec3 E = c.environment.irradiance.at(0);
    if (setup.reference_samples > 0) {
        const std::string N = std::to_string(setup.reference_samples);
        section.equation("E", "1 / N Σ L(l_k) (n·l_k) / (p_cos + p_light)", "", E,
                         "N = " + N + " directions by their cosine to n and " + N + " by the environment's light");
        section.equation("error", "", "", c.environment.error.at(0), "standard error of E / π, luminance");
        return;
    }
    section.equation("E", "intensity E(n)", "", E,
                     setup.maps->sh9 ? "irradiance on n, from nine coefficients" : "irradiance on n, from its map");
}

/// Where the prefiltered map is read, and what stands there.
void explain_prefiltered(const LightingChannels& c, Section& section) {
    const MicrofacetChannels& m = c.microfacet;
    const EnvironmentChannels& e = c.environment;
    const glm::vec3 n = c.n.at(0), v = c.v.at(0);
    const float alpha = m.surface.at(0).alpha;
    section.equation("n·v", "max(n·v, 0)", "max(" + dot_text(n, v) + ", 0)", m.n_dot_v.at(0));
    section.equation("r", "2 (n·v) n - v", "", e.direction.at(0), "the mirror direction");
    section.equation("α", "roughness²", number_text(m.surface.at(0).roughness) + "²", alpha);
    const bool between_mirror_and_first = alpha < lighting::alpha_of_level(1);
    section.equation("level", between_mirror_and_first ? "64 α" : "7 + log2 α",
                     between_mirror_and_first ? "64·" + number_text(alpha) : "7 + log2 " + number_text(alpha),
                     lighting::level_of_alpha(alpha), "of the prefiltered map: 0 is a mirror, 7 is roughness 1");
    section.equation("P", "intensity prefiltered(r, level)", "", e.prefiltered.at(0),
                     "radiance around r, blurred as the surface is rough");
}

void explain_split_sum(const lighting::CookTorranceSetup& setup, const LightingChannels& c, Section& section) {
    const MicrofacetChannels& m = c.microfacet;
    const EnvironmentChannels& e = c.environment;
    explain_prefiltered(c, section);
    const glm::vec3 albedo = m.surface.at(0).albedo, f0 = m.surface.at(0).f0, brdf = e.brdf.at(0), F = e.F.at(0);
    const glm::vec3 E = e.irradiance.at(0), P = e.prefiltered.at(0);
    const float metallic = m.surface.at(0).metallic;
    const std::string ao = number_text(m.ao.at(0)), A = number_text(brdf.x), B = number_text(brdf.y);
    section.equation("A", "", "", brdf.x, "scale of F0: the BRDF map at n·v and roughness");
    section.equation("B", "", "", brdf.y, "and its bias");
    section.equation("c", "", "", albedo, "albedo");
    section.equation("F0", "0.04 (1 - metallic) + c metallic", "", f0, "or what ior and measured materials say");
    section.equation("F", "F(n·v)", "", F, "Fresnel reflectance at n·v");
    const glm::vec3 k_d = lighting::diffuse_share(F, metallic);
    section.equation("k_d", "(1 - F)(1 - metallic)",
                     vector_text(glm::vec3(1.0f) - F) + " · " + number_text(1.0f - metallic), k_d,
                     "what enters the surface and comes out again");
    section.equation("ao", "", "", m.ao.at(0), "share of the environment's light that arrives");
    section.equation("env_D", "ao k_d c E / π",
                     ao + " · " + vector_text(k_d) + " ⊗ " + vector_text(albedo) + " ⊗ " + vector_text(E) + " / π",
                     e.diffuse.at(0), "diffuse light from the environment");
    const std::string single = vector_text(P) + " ⊗ (" + vector_text(f0) + "·" + A + " + " + B + ")";
    if (setup.energy_compensation == lighting::EnergyCompensation::none) {
        section.equation("env_S", "ao P (F0 A + B)", ao + " · " + single, e.specular.at(0), "specular light from it");
        return;
    }
    const glm::vec3 F_ms = lighting::multiple_scattering_color(f0, setup.f_avg_shift, brdf.z);
    section.equation("F_ms", "", "", F_ms, "what is left after several bounces between the facets: Kulla and Conty");
    section.equation("env_S", "ao (P (F0 A + B) + F_ms (1 - A - B) E / π)",
                     ao + " · (" + single + " + " + vector_text(F_ms) + " ⊗ " + number_text(1.0f - (brdf.x + brdf.y)) +
                         "·" + vector_text(E) + " / π)",
                     e.specular.at(0), "specular light from it");
}

/// The integral itself: no maps to read, sums over samples.
void explain_samples(const LitPoint& point, const LightingChannels& c, Section& section) {
    const std::string N = std::to_string(point.frame.lighting.environment.reference_samples);
    section.equation("env_D", "ao / N Σ k_d c / π L(l_k) (n·l_k) / (p_cos + p_light)", "", c.environment.diffuse.at(0),
                     "N = " + N + " directions by their cosine to n and " + N + " by the environment's light");
    section.equation("env_S", "ao / N Σ D V F L(l_k) (n·l_k) / (p_facet + p_light)", "", c.environment.specular.at(0),
                     "l_k: v mirrored in " + N + " facets that v sees, and " + N + " by the environment's light");
    section.equation("error", "", "", c.environment.error.at(0), "standard error of env_D + env_S, luminance");
}

}  // namespace

void explain_environment(const LitPoint& point, const LightingChannels& c, Section& section) {
    const lighting::MaterialSetup& material = point.frame.plan.materials[point.material];
    const bool exact = point.frame.lighting.environment.reference_samples > 0;
    if (material.material.model == lighting::ReflectionModel::cook_torrance) {
        if (exact) return explain_samples(point, c, section);
        explain_irradiance(point, c, section);
        return explain_split_sum(material.cook_torrance, c, section);
    }
    explain_irradiance(point, c, section);
    const glm::vec3 m_D = material.maps.diffuse.texture ? c.m_D.at(0) : material.material.phong.diffuse;
    section.equation("env_D", "m_D E / π",
                     vector_text(m_D) + " ⊗ " + vector_text(c.environment.irradiance.at(0)) + " / π",
                     c.environment.diffuse.at(0), "diffuse light from the environment");
    section.equation("env_S", "", "", c.environment.specular.at(0), "this model's highlights are made for lamps");
}

void explain_background_color(const SampleFacts& sample, Section& section) {
    const scene::Frame& frame = sample.frame;
    if (!frame.scene.image.environment_background) {
        section.equation("radiance", "image.background", "", sample.radiance, "linear RGB");
        return;
    }
    const scene::ViewRays rays = scene::view_rays(frame.scene.camera, frame.plan.viewport);
    const float x = static_cast<float>(sample.x) + 0.5f, y = static_cast<float>(sample.y) + 0.5f;
    section.equation("d", "corner + (x + 1/2) right + (y + 1/2) down",
                     vector_text(rays.corner) + " + " + number_text(x) + "·" + vector_text(rays.right) + " + " +
                         number_text(y) + "·" + vector_text(rays.down),
                     rays.corner + y * rays.down + x * rays.right, "along the line of sight, not unit");
    section.equation("radiance", "intensity environment(d)", "", sample.radiance, "linear RGB");
}

}  // namespace kreda::tools
