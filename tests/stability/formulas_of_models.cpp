// The models of lighting/reflection.hpp and cook_torrance.hpp, and Heidrich and Seidel's, as a whole, in long double.
#include <algorithm>
#include <cmath>

#include "lighting/cook_torrance.hpp"
#include "lighting/fog.hpp"
#include "lighting/spectrum.hpp"
#include "lighting/ward.hpp"
#include "tests/stability/two_directions.hpp"

namespace kreda::tests {

namespace {

using namespace kreda::lighting;

std::vector<Axis> with(std::vector<Axis> axes, const std::vector<Axis>& more) {
    axes.insert(axes.end(), more.begin(), more.end());
    return axes;
}

std::vector<Formula> parts() {
    const Axis share{0.0f, 1.0f, Spread::even, {1e-8f, 0.5f}};
    const Axis signed_share{-1.0f, 1.0f, Spread::even, {0.0f, 1e-8f, -1e-7f}};
    const Axis light{0.0f, 1e9f, Spread::even, {1e-8f, 1.0f}};
    return {
        {"positive_dot", "two unit vectors", "[0, 1.0000004]", 0, 1.0000004, false, 2e-7, kTwoDirections,
         [](const Inputs& x) { return positive_dot(l_of(x), v_of(x)); },
         [](const Inputs& x) { return positive(glm::dot(Wide(l_of(x)), Wide(v_of(x)))); }},
        {"ambient_term",
         "s_A in [0, 1e9], m_A in [0, 1]",
         "[0, 1e9]",
         0,
         1e9,
         true,
         1e-7,
         {light, share},
         [](const Inputs& x) { return ambient_term(glm::vec3(x[0]), glm::vec3(x[1])).y; },
         [](const Inputs& x) { return Real{x[0]} * x[1]; }},
        {"blinn_exponent_matching_phong",
         "shininess in [0, 1e9]",
         "[0, 4e9]",
         0,
         4e9,
         true,
         0,
         {light},
         [](const Inputs& x) { return blinn_exponent_matching_phong(x[0]); },
         [](const Inputs& x) { return 4 * Real{x[0]}; }},
        {"faces_light",
         "n·l in [-1, 1]",
         "0 or 1",
         0,
         1,
         false,
         0,
         {signed_share},
         [](const Inputs& x) { return faces_light(x[0]); },
         [](const Inputs& x) { return x[0] > 0.0f ? Real{1} : Real{0}; }},
        {"base_reflectivity",
         "albedo, metallic in [0, 1]",
         "[0, 1]",
         0,
         1,
         false,
         1.2e-7,
         {share, share},
         [](const Inputs& x) { return base_reflectivity(glm::vec3(x[0]), x[1]).x; },
         [](const Inputs& x) { return Real{kDielectricF0} * (1 - Real{x[1]}) + Real{x[0]} * x[1]; }},
        {"diffuse_share",
         "F, metallic in [0, 1]",
         "[0, 1]",
         0,
         1,
         false,
         1.2e-7,
         {share, share},
         [](const Inputs& x) { return diffuse_share(glm::vec3(x[0]), x[1]).z; },
         [](const Inputs& x) { return (1 - Real{x[0]}) * (1 - Real{x[1]}); }},
        {"combine_terms",
         "n·l, F, albedo, metallic in [0, 1]: diffuse",
         "[0, 0.3184]",
         0,
         0.3184,
         false,
         1e-7,
         {share, share, share, share},
         [](const Inputs& x) {
             return combine_terms(x[0], 1.0f, 1.0f, glm::vec3(x[1]), glm::vec3(x[2]), x[3]).diffuse.x;
         },
         [](const Inputs& x) { return (1 - Real{x[1]}) * (1 - Real{x[3]}) * x[2] * x[0] / kPi; }},
        {"combine_terms",
         "n·l, F in [0, 1], D in [0, 8e4], V in [0, 1e12]: specular",
         "[0, 8e16]",
         0,
         8.1e16,
         true,
         4e-7,
         {share, {0.0f, 8e4f, Spread::even, {1.0f}}, {0.0f, 1e12f, Spread::even, {0.25f}}, share},
         [](const Inputs& x) {
             return combine_terms(x[0], x[1], x[2], glm::vec3(x[3]), glm::vec3(0.5f), 0.0f).specular.x;
         },
         [](const Inputs& x) { return Real{x[0]} * x[1] * x[2] * x[3]; }},
        {"mix_fog",
         "f in [0, 1], both colours in [0, 1e9]",
         "[0, 1e9]",
         0,
         1.0000001e9,
         true,
         2.5e-7,
         {share, light, light},
         [](const Inputs& x) { return mix_fog(x[0], glm::vec3(x[1]), glm::vec3(x[2])).x; },
         [](const Inputs& x) { return Real{x[0]} * x[1] + (1 - Real{x[0]}) * x[2]; }},
        {"reflected_at",
         "c in [0, 1], n in [0.001, 1000], k in [0, 1000], colour 1",
         "[0, 1]",
         0,
         1,
         false,
         4e-7,
         {share, {1e-3f, 1e3f, Spread::logarithmic, {1.5f}}, {0.0f, 1e3f, Spread::even, {1.0f}}},
         [](const Inputs& x) { return reflected_at(x[0], glm::vec3(1.0f), x[1], x[2]).x; },
         [](const Inputs& x) { return Real{fresnel_conductor(x[0], x[1], x[2])}; }},
    };
}

std::vector<Formula> vectors() {
    const Axis length{1e-15f, 1e18f, Spread::logarithmic, {1.0f}};
    const auto mirror = [](const Inputs& x) {
        return 2 * glm::dot(Wide(l_of(x)), Wide(v_of(x))) * Wide(v_of(x)) - Wide(l_of(x));
    };
    return {
        formula_of({"mirror_vector", "l, n unit to 3e-7", "[0, 1.000001]", 1.000001, false, 6e-7, kTwoDirections,
                    [](const Inputs& x) { return mirror_vector(v_of(x), l_of(x)); }, mirror}),
        formula_of({"half_vector", "l, v unit to 3e-7", "[0, 1.0000004]", 1.0000004, false, 4e-7, kTwoDirections,
                    [](const Inputs& x) { return half_vector(l_of(x), v_of(x)); },
                    [](const Inputs& x) { return wide_unit(Wide(l_of(x)) + Wide(v_of(x))); }}),
        formula_of({"tangent_of_grain",
                    "grain, n unit to 3e-7, 0.001 apart or more",
                    "[0, 1.0000004]",
                    1.0000004,
                    false,
                    3e-4,
                    {{-0.9999f, 0.9999f, Spread::even, {0.0f}}, kTurn},
                    [](const Inputs& x) { return tangent_of_grain(direction(x[0], x[1]), kUp); },
                    [](const Inputs& x) {
                        const Wide g(direction(x[0], x[1]));
                        return wide_unit(Wide(g.x, g.y, Real{0}));
                    }}),
        {"planar_distance",
         "components whose largest is in [1e-15, 1e18], forward unit",
         "[0, 1.8e18]",
         0,
         1.8e18,
         true,
         2e-7,
         {length, length, length},
         [](const Inputs& x) {
             return planar_distance({x[0], x[1], x[2]}, glm::vec3(0.0f), glm::vec3(0.6f, 0.0f, 0.8f));
         },
         [](const Inputs& x) { return Real{0.6f} * x[0] + Real{0.8f} * x[2]; }},
    };
}

std::vector<Formula> phong_family() {
    const Axis shininess{1e-3f, 1e3f, Spread::logarithmic, {1.0f, 64.0f}, {0.0f}};
    const auto gloss = [](Real sigma, const Inputs& x) {
        return x[0] > 0.0f ? Real{0.5f} * std::pow(positive(sigma), Real{x[4]}) : Real{0};
    };
    return {
        {"lambert",
         "n, l unit to 3e-7, m_D = 0.75",
         "[0, 0.7500003]",
         0,
         0.7500003,
         false,
         2e-7,
         {kHeight, kTurn},
         [](const Inputs& x) { return lambert(kUp, l_of(x), shiny(1.0f)).diffuse.x; },
         [](const Inputs& x) { return Real{0.75f} * positive(x[0]); }},
        {"phong_terms",
         "n·l in [-1, 1], highlight in [0, 1]: specular, m_S = 0.5",
         "[0, 0.5]",
         0,
         0.5,
         false,
         0,
         {kHeight, kUpperHeight},
         [](const Inputs& x) { return phong_terms(x[0], x[1], shiny(1.0f)).specular.x; },
         [](const Inputs& x) { return Real{0.5f} * x[1]; }},
        {"phong", "n, l, v unit to 3e-7, shininess in [0, 1000]: specular, m_S = 0.5", "[0, 0.5]", 0, 0.5, false, 3e-4,
         with(kTwoDirections, {shininess}),
         [](const Inputs& x) { return phong(kUp, l_of(x), v_of(x), shiny(x[4])).specular.x; },
         [=](const Inputs& x) {
             const Wide l(l_of(x)), v(v_of(x));
             return gloss(std::min(2 * l.z * v.z - glm::dot(l, v), Real{1}), x);
         }},
        {"blinn_phong", "n, l, v unit to 3e-7, shininess 0 or in [1, 1000]: specular, m_S = 0.5", "[0, 0.5]", 0, 0.5,
         false, 3e-4, with(kTwoDirections, {{1.0f, 1e3f, Spread::logarithmic, {64.0f}, {0.0f}}}),
         [](const Inputs& x) { return blinn_phong(kUp, l_of(x), v_of(x), shiny(x[4])).specular.x; },
         [=](const Inputs& x) { return gloss(std::min(wide_unit(Wide(l_of(x)) + Wide(v_of(x))).z, Real{1}), x); }},
        {"heidrich_seidel", "n, t, l, v unit to 3e-7, shininess in [0, 1000]: specular, m_S = 0.5", "[0, 0.5]", 0, 0.5,
         false, 3e-4, with(kTwoDirections, {shininess}),
         [](const Inputs& x) {
             return heidrich_seidel(kUp, {1.0f, 0.0f, 0.0f}, l_of(x), v_of(x), shiny(x[4])).specular.x;
         },
         [](const Inputs& x) {
             const Wide l(l_of(x)), v(v_of(x));
             const Real sines = std::sqrt((1 - l.x * l.x) * (1 - v.x * v.x));
             const Real sigma = std::clamp(sines - l.x * v.x, Real{0}, Real{1});
             return Real{0.5f} * std::pow(sigma, Real{x[4]}) * positive(l.z);
         }},
    };
}

/// Highlights so narrow that the rounding of two unit vectors is seen: v lies beside the mirror image of l. Sigma is
/// wrong by 1.2e-7, and a million times that is 0.12 of the highlight's 0.5.
std::vector<Formula> narrow_highlights() {
    const Axis exponent{1e3f, 1e6f, Spread::logarithmic, {}};
    const Axis beside{0.0f, 0.004f, Spread::even, {1e-8f, 1e-4f}};
    const std::vector<Axis> axes = {{0.1f, 1.0f, Spread::even, {0.5f}}, kTurn, beside, exponent};
    const auto light = [](const Inputs& x) { return direction(x[0], x[1]); };
    const auto viewer = [](const Inputs& x) {
        const glm::vec3 l = direction(x[0], x[1]);
        return glm::vec3(glm::normalize(Wide(-l.x, -l.y, l.z) + Real{x[2]} * Wide(0, 0.6L, 0.8L)));
    };
    const auto gloss = [](Real sigma, float shininess) {
        return Real{0.5f} * std::pow(std::min(sigma, Real{1}), Real{shininess});
    };
    return {
        {"phong", "v beside the mirror image of l, shininess in [1000, 1e6]: specular, m_S = 0.5", "[0, 0.5]", 0, 0.5,
         false, 0.07, axes, [=](const Inputs& x) { return phong(kUp, light(x), viewer(x), shiny(x[3])).specular.x; },
         [=](const Inputs& x) {
             const Wide l(light(x)), v(viewer(x));
             return gloss(2 * l.z * v.z - glm::dot(l, v), x[3]);
         }},
        {"blinn_phong", "v beside the mirror image of l, shininess in [1000, 1e6]: specular, m_S = 0.5", "[0, 0.5]", 0,
         0.5, false, 0.07, axes,
         [=](const Inputs& x) { return blinn_phong(kUp, light(x), viewer(x), shiny(x[3])).specular.x; },
         [=](const Inputs& x) { return gloss(wide_unit(Wide(light(x)) + Wide(viewer(x))).z, x[3]); }},
    };
}

/// D V F (n.l) of a metal with GGX, Smith's correlated V and Schlick's F.
std::vector<Formula> cook_and_torrance() {
    const auto metal = [](float roughness) {
        CookTorranceMaterial m;
        m.distribution = Distribution::ggx;
        m.geometry = Geometry::smith_correlated;
        m.fresnel = FresnelMethod::schlick;
        m.albedo = glm::vec3(0.5f);
        m.metallic = 1.0f;
        m.roughness = roughness;
        return prepare(m);
    };
    return {
        {"cook_torrance",
         "n·l, n·v in [0.01, 1], roughness in [0.3, 1], a metal of 0.5: specular",
         "[0, 120]",
         0,
         120,
         true,
         2e-5,
         {{0.01f, 1.0f, Spread::even, {0.5f}},
          kAnyTurn,
          {0.01f, 1.0f, Spread::even, {0.5f}},
          kTurn,
          {0.3f, 1.0f, Spread::even, {}}},
         [=](const Inputs& x) { return cook_torrance(kUp, l_of(x), v_of(x), metal(x[4])).specular.x; },
         [](const Inputs& x) {
             const Wide sum = Wide(l_of(x)) + Wide(v_of(x)), h = wide_unit(sum);
             const Real alpha = Real{x[4]} * x[4], alpha2 = alpha * alpha, s2 = h.x * h.x + h.y * h.y;
             const Real q = s2 + h.z * h.z * alpha2, D = alpha2 / (kPi * q * q);
             const auto root = [&](Real c) { return std::sqrt(alpha2 + (1 - alpha2) * c * c); };
             const Real V = 1 / (2 * (x[0] * root(x[2]) + x[2] * root(x[0])));
             const Real F = 0.5L + 0.5L * std::pow(1 - std::min(glm::length(sum) / 2, Real{1}), Real{5});
             return D * V * F * x[0];
         }},
    };
}

}  // namespace

std::vector<Formula> formulas_of_models() {
    return joined(joined(phong_family(), narrow_highlights()), joined(cook_and_torrance(), joined(parts(), vectors())));
}

}  // namespace kreda::tests
