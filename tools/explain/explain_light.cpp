#include "tools/explain/explain_light.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <glm/geometric.hpp>

#include "lighting/light.hpp"
#include "lighting/light_sample.hpp"
#include "lighting/reflection.hpp"
#include "scene/files/scene_keys.hpp"
#include "scene/plan/pass_functions.hpp"
#include "scene/render/shade.hpp"
#include "tools/explain/explain_shadow.hpp"

namespace kreda::tools {

namespace {

using lighting::LightingChannels;
using lighting::LightSetup;
using lighting::ReflectionModel;

/// The lighting passes of a frame up to and with its first `light_count` lights.
std::span<const scene::PlannedPass> passes_up_to(const scene::Frame& frame, std::size_t light_count) {
    const auto is_later = [&](const scene::PlannedPass& pass) {
        return pass.run == scene::add_light && pass.index >= static_cast<int>(light_count);
    };
    const auto end = std::find_if(frame.lighting_passes.begin(), frame.lighting_passes.end(), is_later);
    return {frame.lighting_passes.begin(), end};
}

/// The channels after the first `light_count` lights: the passes of the real render over a batch of one.
std::unique_ptr<LightingChannels> channels_after(const LitPoint& point, std::size_t light_count) {
    scene::Frame frame = point.frame;
    frame.lighting_passes = passes_up_to(frame, light_count);
    auto channels = std::make_unique<LightingChannels>();
    scene::shade_points(frame, point.points, point.material, *channels, *frame.buffers.scratch[0]);
    return channels;
}

/// The word that a scene file has for an enumerator.
template <class Enum>
std::string word_for(std::string_view table, std::string_view key, Enum value) {
    return std::string(scene::find_key(table, key)->words[static_cast<std::size_t>(value)]);
}

void explain_directions(const LitPoint& point, const LightingChannels& c, Section& section) {
    const glm::vec3 p = point.points.position.at(0);
    const glm::vec3 normal = point.points.normal.at(0);
    section.equation("p", "", "", p, "world space");
    section.equation("|normal|", "√(normal·normal)", "", std::sqrt(glm::dot(normal, normal)));
    const bool bent = point.frame.plan.materials[point.material].map_needs.tangent;
    section.equation(bent ? "n0" : "n", "normal / |normal|",
                     vector_text(normal) + " / " + number_text(glm::length(normal)), lighting::unit(normal));
    if (bent) explain_bent_normal(point, c, section);
    if (point.frame.lighting.orthographic) {
        section.equation("v", "-forward", "", c.v.at(0), "the same everywhere: orthographic");
        return;
    }
    const glm::vec3 to_eye = point.frame.lighting.eye - p;
    section.equation("v", "(eye - p) / |eye - p|", vector_text(to_eye) + " / " + number_text(glm::length(to_eye)),
                     c.v.at(0));
}

/// m_E, with a line of its own where a map has a say.
glm::vec3 explain_emission(const lighting::MaterialSetup& setup, const LightingChannels& c, Section& section) {
    const glm::vec3 constant = setup.material.phong.emission;
    if (!setup.maps.emission.texture) return constant;
    const glm::vec3 of_map = c.map_emission.at(0);
    section.equation("m_E", "emission ⊗ emission_map", vector_text(constant) + " ⊗ " + vector_text(of_map),
                     constant * of_map);
    return constant * of_map;
}

/// What the surface shows without lamps and without an environment.
glm::vec3 explain_own_light(const LitPoint& point, const LightingChannels& c, Section& section) {
    const lighting::MaterialSetup& setup = point.frame.plan.materials[point.material];
    const glm::vec3 m_E = explain_emission(setup, c, section);
    if (setup.material.model == ReflectionModel::cook_torrance) {
        section.equation("ambient", "m_E", "", m_E, "the microfacet model knows no ambient light");
        return m_E;
    }
    const glm::vec3 s_A = point.frame.lighting.ambient, m_A = setup.material.phong.ambient;
    const glm::vec3 ambient = lighting::ambient_term(s_A, m_A) + m_E;
    section.equation("ambient", "s_A ⊗ m_A + m_E",
                     vector_text(s_A) + " ⊗ " + vector_text(m_A) + " + " + vector_text(m_E), ambient);
    return ambient;
}

/// What is there without any lamp.
void explain_ambient(const LitPoint& point, const LightingChannels& c, Section& section) {
    const lighting::MaterialSetup& setup = point.frame.plan.materials[point.material];
    const lighting::Material& material = setup.material;
    if (material.model == ReflectionModel::unlit) {
        const glm::vec3 m_D = setup.maps.diffuse.texture ? c.m_D.at(0) : material.phong.diffuse;
        const glm::vec3 m_E = explain_emission(setup, c, section);
        section.equation("ambient", "m_D + m_E", vector_text(m_D) + " + " + vector_text(m_E), c.ambient.at(0),
                         "unlit: no light matters");
        return;
    }
    const glm::vec3 own = explain_own_light(point, c, section);
    if (!point.frame.plan.lit_by_environment) return;
    explain_environment(point, c, section);
    section.equation("ambient", "ambient + env_D + env_S",
                     vector_text(own) + " + " + vector_text(c.environment.diffuse.at(0)) + " + " +
                         vector_text(c.environment.specular.at(0)),
                     c.ambient.at(0), "with the environment");
}

/// d and l of a light that has a place.
float explain_distance(const LightSetup& light, const glm::vec3& p, const LightingChannels& c, Section& section) {
    const glm::vec3 to_light = light.position - p;
    const float d = glm::length(to_light);
    section.equation("d", "|p_light - p|", "|" + vector_text(light.position) + " - " + vector_text(p) + "|", d);
    section.equation("l", "(p_light - p) / d", vector_text(to_light) + " / " + number_text(d), c.l.at(0));
    return d;
}

std::string explain_attenuation(const LightSetup& light, float d, Section& section) {
    const lighting::Attenuation& a = light.attenuation;
    const float weakened = lighting::attenuate(a, d);
    section.equation("a", "1 / (c + l d + q d²)",
                     "1 / (" + number_text(a.constant) + " + " + number_text(a.linear) + "·" + number_text(d) + " + " +
                         number_text(a.quadratic) + "·" + number_text(d) + "²)",
                     weakened);
    return number_text(weakened);
}

std::string explain_cone(const LightSetup& light, const LightingChannels& c, Section& section) {
    const glm::vec3 l = c.l.at(0);
    const float cosine = -glm::dot(l, light.axis);
    const float cone = lighting::spot_cone(cosine, light.cos_inner, light.cos_outer);
    section.equation("cos γ", "-l·axis", "-(" + dot_text(l, light.axis) + ")", cosine,
                     "between the ray and the spot's axis");
    section.equation("t", "(cos γ - cos outer) / (cos inner - cos outer), in 0..1",
                     "(" + number_text(cosine) + " - " + number_text(light.cos_outer) + ") / (" +
                         number_text(light.cos_inner) + " - " + number_text(light.cos_outer) + ")",
                     std::vector<double>{});
    section.equation("cone", "3t² - 2t³", "", cone);
    return number_text(cone);
}

/// What the light sends, before any shadow.
lighting::LightSample sample_of(const LightSetup& light, const glm::vec3& p) {
    switch (light.type) {
        case lighting::LightType::directional: return sample_directional(light);
        case lighting::LightType::point: return sample_point(light, p);
        case lighting::LightType::spot: return sample_spot(light, p);
    }
    return {};
}

/// What light k of those that are on casts, or nullptr.
const scene::PlannedShadow* shadow_of(const scene::Frame& frame, std::size_t k) {
    for (const scene::PlannedShadow& shadow : frame.plan.shadows) {
        if (shadow.light_that_is_on == static_cast<int>(k)) return &shadow;
    }
    return nullptr;
}

/// How the shadow was found, and its share of the light.
void explain_shadow_of(const LitPoint& point, const scene::PlannedShadow& planned, float lit, Section& section) {
    const shadows::ShadowSettings& s = planned.map.settings;
    const bool map = s.method == shadows::ShadowMethod::map;
    section.say("Its shadow, by shadow.method = \"" + word_for("shadow", "method", s.method) + "\"" +
                (map ? ", filter \"" + word_for("shadow", "filter", s.filter) + "\", bias \"" +
                           word_for("shadow", "bias", s.bias) + "\""
                     : "") +
                ":");
    explain_shadow(point, planned, section);
    section.equation("shadow", "", "", lit,
                     lit == 1.0f   ? "nothing stands before this light"
                     : lit == 0.0f ? "something stands before this light"
                                   : "partly in shadow");
}

/// l and s of a light, and what a shadow leaves of it.
void explain_sample(const LitPoint& point, std::size_t k, const LightingChannels& c, Section& section) {
    const LightSetup& light = point.frame.lighting.lights[k];
    const glm::vec3 p = point.points.position.at(0);
    std::string factors = vector_text(light.radiance);
    std::string formula = "color intensity";
    if (light.type == lighting::LightType::directional) {
        section.equation("l", "-direction / |direction|", "", c.l.at(0), "the same everywhere");
    } else {
        const float d = explain_distance(light, p, c, section);
        factors += " · " + explain_attenuation(light, d, section);
        formula += " a";
    }
    if (light.type == lighting::LightType::spot) {
        factors += " · " + explain_cone(light, c, section);
        formula += " cone";
    }
    const lighting::LightSample unshadowed = sample_of(light, p);
    section.equation("s", formula, factors, unshadowed.irradiance, "what arrives on a plane that faces the light");
    const scene::PlannedShadow* planned = shadow_of(point.frame, k);
    if (!planned) return;
    const float lit = c.shadow.at(0);
    explain_shadow_of(point, *planned, lit, section);
    section.equation("s", "shadow s", number_text(lit) + " · " + vector_text(unshadowed.irradiance), c.irradiance.at(0),
                     "what is left of it");
}

Section light_section(const LitPoint& point, std::size_t k, const LightSetup& light) {
    const std::string number = std::to_string(scene::index_of_light(point.frame.scene, static_cast<int>(k)));
    return {point.id + "light_" + number,
            point.name + "light." + number + " (" + word_for("light", "type", light.type) + ")",
            {}};
}

/// One light: what it sends, what the surface reflects of it, and the sums with it.
void explain_light(const LitPoint& point, std::size_t k, const LightingChannels& before, const LightingChannels& after,
                   Derivation& derivation) {
    const LightSetup& light = point.frame.lighting.lights[k];
    Section section = light_section(point, k, light);
    explain_sample(point, k, after, section);
    const lighting::ReflectedTerms terms =
        explain_reflection(point.frame.plan.materials[point.material], after, section);
    const glm::vec3 s = after.irradiance.at(0);
    section.equation("L_D", "s ⊗ f_D", vector_text(s) + " ⊗ " + vector_text(terms.diffuse), s * terms.diffuse,
                     "diffuse light of this lamp");
    section.equation("L_S", "s ⊗ f_S", vector_text(s) + " ⊗ " + vector_text(terms.specular), s * terms.specular,
                     "specular light of this lamp");
    if (k > 0) {
        section.equation("diffuse", "so far + L_D",
                         vector_text(before.diffuse.at(0)) + " + " + vector_text(s * terms.diffuse),
                         after.diffuse.at(0));
        section.equation("specular", "so far + L_S",
                         vector_text(before.specular.at(0)) + " + " + vector_text(s * terms.specular),
                         after.specular.at(0));
    }
    derivation.sections.push_back(section);
}

}  // namespace

glm::vec3 explain_lighting(const LitPoint& point, Derivation& derivation) {
    const lighting::Material& material = point.frame.plan.materials[point.material].material;
    const bool lit = material.model != ReflectionModel::unlit;
    const std::size_t light_count = lit ? point.frame.lighting.lights.size() : 0;
    std::unique_ptr<LightingChannels> before = channels_after(point, 0);

    explain_maps(point, *before, derivation);
    Section base{point.id + "surface", point.name + "the surface and what it shows without lamps", {}};
    base.say("Material \"" + material.name + "\", model " + word_for("material", "model", material.model) + ".");
    if (lit) explain_directions(point, *before, base);
    explain_ambient(point, *before, base);
    derivation.sections.push_back(base);

    for (std::size_t k = 0; k < light_count; ++k) {
        std::unique_ptr<LightingChannels> after = channels_after(point, k + 1);
        explain_light(point, k, *before, *after, derivation);
        before = std::move(after);
    }
    Section sum{point.id + "sum", point.name + "the sum", {}};
    const glm::vec3 radiance = before->radiance.at(0);
    const std::string numbers = vector_text(before->ambient.at(0)) + " + " + vector_text(before->diffuse.at(0)) +
                                " + " + vector_text(before->specular.at(0));
    sum.equation("radiance", "ambient + diffuse + specular", numbers, radiance, "linear RGB");
    derivation.sections.push_back(sum);
    return radiance;
}

}  // namespace kreda::tools
