// The models of lighting/reflection.hpp, ward.hpp and cook_torrance.hpp as a whole, in long double: n is upwards, the
// other directions are anywhere.
#include <algorithm>
#include <cmath>

#include "lighting/cook_torrance.hpp"
#include "lighting/fog.hpp"
#include "lighting/spectrum.hpp"
#include "lighting/ward.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

namespace {

using namespace kreda::lighting;

const glm::vec3 kUp{0.0f, 0.0f, 1.0f};
const std::vector<Axis> kTwoDirections = {kHeight, kTurn, kHeight, kTurn};

/// l and v of the first four inputs.
glm::vec3 l_of(const Inputs& x) {
    return direction(x[0], x[1]);
}
glm::vec3 v_of(const Inputs& x) {
    return direction(x[2], x[3]);
}

Real positive(Real x) {
    return std::max(x, Real{0});
}

/// What is shorter than 1e-15 has no direction: it comes out shorter than 1, as in float.
Wide wide_unit(const Wide& v) {
    return v / std::max(glm::length(v), Real{1e-15f});
}

PhongMaterial shiny(float shininess) {
    PhongMaterial m;
    m.diffuse = glm::vec3(0.75f);
    m.specular = glm::vec3(0.5f);
    m.shininess = shininess;
    return m;
}

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
    const Axis shininess{1e-3f, 1e3f, Spread::logarithmic, {1.0f, 64.0f}};
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
        {"phong", "n, l, v unit to 3e-7, shininess in [0.001, 1000]: specular, m_S = 0.5", "[0, 0.5]", 0, 0.5, false,
         3e-4, with(kTwoDirections, {shininess}),
         [](const Inputs& x) { return phong(kUp, l_of(x), v_of(x), shiny(x[4])).specular.x; },
         [=](const Inputs& x) {
             const Wide l(l_of(x)), v(v_of(x));
             return gloss(std::min(2 * l.z * v.z - glm::dot(l, v), Real{1}), x);
         }},
        {"blinn_phong", "n, l, v unit to 3e-7, shininess in [1, 1000]: specular, m_S = 0.5", "[0, 0.5]", 0, 0.5, false,
         3e-4, with(kTwoDirections, {{1.0f, 1e3f, Spread::logarithmic, {64.0f}}}),
         [](const Inputs& x) { return blinn_phong(kUp, l_of(x), v_of(x), shiny(x[4])).specular.x; },
         [=](const Inputs& x) { return gloss(std::min(wide_unit(Wide(l_of(x)) + Wide(v_of(x))).z, Real{1}), x); }},
        {"heidrich_seidel", "n, t, l, v unit to 3e-7, shininess in [0.001, 1000]: specular, m_S = 0.5", "[0, 0.5]", 0,
         0.5, false, 3e-4, with(kTwoDirections, {shininess}),
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

/// tan² theta_h times the share of each width, in long double.
Real grain_exponent(const Wide& h, Real alpha_t, Real alpha_b) {
    const Real slopes = h.x * h.x / (alpha_t * alpha_t) + h.y * h.y / (alpha_b * alpha_b);
    return slopes / std::max(h.z * h.z, Real(1e-12f));
}

std::vector<Formula> ward_family() {
    const Axis alpha{0.002f, 1.0f, Spread::logarithmic, {}};
    const auto h_of = [](const Inputs& x) { return wide_unit(Wide(l_of(x)) + Wide(v_of(x))); };
    const std::vector<Axis> above = {kUpperHeight, kAnyTurn, kUpperHeight, kAnyTurn, alpha, alpha};
    const auto exact_ward = [=](const Inputs& x) {
        const Real product = positive(x[0]) * positive(x[2]);
        if (product <= 0) return Real{0};
        const Real lobe = std::exp(-grain_exponent(h_of(x), x[4], x[5])) / (4 * kPi * x[4] * x[5]);
        return lobe / std::sqrt(std::max(product, Real(1e-12f)));
    };
    const glm::vec3 t{1.0f, 0.0f, 0.0f}, b{0.0f, 1.0f, 0.0f};
    return {
        {"ward_exponent",
         "h, n, t, b unit to 3e-7, both alpha in [0.002, 1]",
         "[0, 2.6e17]",
         0,
         2.6e17,
         true,
         6e-7,
         {kHeight, kTurn, alpha, alpha},
         [=](const Inputs& x) { return ward_exponent(direction(x[0], x[1]), kUp, t, b, x[2], x[3]); },
         [](const Inputs& x) { return grain_exponent(Wide(direction(x[0], x[1])), x[2], x[3]); }},
        {"ward_anisotropic", "all unit to 3e-7, n·l, n·v in [0, 1], both alpha in [0.002, 1]", "[0, 2e10]", 0, 2e10,
         true, 3e-3, above, [=](const Inputs& x) { return ward_anisotropic(kUp, t, b, l_of(x), v_of(x), x[4], x[5]); },
         exact_ward, 1e-25},
        {"ward_brushed", "as ward_anisotropic: specular, m_S = 0.5", "[0, 4e10]", 0, 4e10, true, 3e-3, above,
         [=](const Inputs& x) {
             return ward_brushed(kUp, t, l_of(x), v_of(x), shiny(1.0f), {x[4], x[5]}).specular.x;
         },
         [=](const Inputs& x) { return Real{0.5f} * kPi * exact_ward(x) * positive(x[0]); }, 1e-25},
        {"ward",
         "n, l, v unit to 3e-7, n·l, n·v in [0, 1], shininess in [0.001, 1000]: specular, m_S = 0.5",
         "[0, 4e8]",
         0,
         4e8,
         true,
         3e-3,
         {kUpperHeight, kAnyTurn, kUpperHeight, kAnyTurn, {1e-3f, 1e3f, Spread::logarithmic, {1.0f, 64.0f}}},
         [](const Inputs& x) { return ward(kUp, l_of(x), v_of(x), shiny(x[4])).specular.x; },
         [=](const Inputs& x) {
             const Real width = std::sqrt(2 / (Real{x[4]} + 2));
             const Real product = positive(x[0]) * positive(x[2]);
             if (product <= 0) return Real{0};
             const Real lobe = std::exp(-grain_exponent(h_of(x), width, width)) / (4 * width * width);
             return Real{0.5f} * lobe / std::sqrt(std::max(product, Real(1e-12f))) * x[0];
         },
         1e-25},
    };
}

}  // namespace

std::vector<Formula> formulas_of_models() {
    return joined(joined(parts(), vectors()), joined(phong_family(), ward_family()));
}

}  // namespace kreda::tests
