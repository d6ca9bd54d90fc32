// The equations of lighting/light.hpp, light_sample.hpp and fog.hpp as the lecture prints them, in long double.
#include <algorithm>
#include <cmath>
#include <limits>

#include "lighting/fog.hpp"
#include "lighting/light.hpp"
#include "lighting/light_sample.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

namespace {

using namespace kreda::lighting;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
const Axis kCoefficient{1e-8f, 1e9f, Spread::logarithmic, {1.0f}, {0.0f}};
const Axis kLength{1e-15f, 1e18f, Spread::logarithmic, {1.0f}};

std::vector<Formula> light_formulas() {
    const Axis distance{1e-15f, 1e18f, Spread::logarithmic, {1e-8f, 1.0f, 1e8f}, {kInfinity}};
    const Axis cosine{-1.0f, 1.0f, Spread::even, {0.0f, 0.5f}};
    return {
        {"attenuate",
         "coefficients in [0, 1e9], the last at least 1, d in [1e-15, inf]",
         "[0, 1e30]",
         0,
         1e30 * 1.000001,
         true,
         4e-7,
         {kCoefficient, kCoefficient, {1.0f, 1e9f, Spread::logarithmic, {}}, distance},
         [](const Inputs& x) {
             return attenuate({x[0], x[1], x[2]}, x[3]);
         },
         [](const Inputs& x) {
             const Real d = std::min(x[3], 1e18f);
             return 1 / (x[0] + x[1] * d + x[2] * d * d);
         }},
        {"attenuate at infinity",
         "constant in [1, 1e9], the others 0",
         "[0, 1]",
         0,
         1,
         false,
         1e-7,
         {{1.0f, 1e9f, Spread::logarithmic, {}}},
         [](const Inputs& x) {
             return attenuate({x[0], 0.0f, 0.0f}, kInfinity);
         },
         [](const Inputs& x) { return 1 / Real{x[0]}; }},
        {"spot_cone",
         "inner = outer, in [-1, 1]: a sharp edge",
         "0 or 1",
         0,
         1,
         false,
         0,
         {cosine, cosine},
         [](const Inputs& x) { return spot_cone(x[0], x[1], x[1]); },
         [](const Inputs& x) { return x[0] >= x[1] ? Real{1} : Real{0}; }},
        {"spot_cone",
         "all cosines in [-1, 1], inner >= outer + 0.001",
         "[0, 1]",
         0,
         1,
         false,
         2e-4,
         {cosine, {-0.99f, 1.0f, Spread::even, {0.5f}}, {0.001f, 0.01f, Spread::even, {}}},
         [](const Inputs& x) { return spot_cone(x[0], x[1], x[1] - x[2]); },
         [](const Inputs& x) {
             const Real outer = x[1] - x[2];  // rounded to float, as the formula gets it
             const Real t = std::clamp((x[0] - Real(float(outer))) / (x[1] - Real(float(outer))), Real{0}, Real{1});
             return t * t * (3 - 2 * t);
         }},
    };
}

/// A lamp of 1 / d², in the point or away from it, of any brightness.
std::vector<Formula> lamp_formulas() {
    const Axis distance{1e-15f, 1e18f, Spread::logarithmic, {1.0f}, {0.0f}};
    const Axis intensity{1e-38f, 1e30f, Spread::logarithmic, {1.0f}, {0.0f}};
    const auto lamp = [](float intensity_) {
        Light light;
        light.type = LightType::point;
        light.position = glm::vec3(0.0f);
        light.intensity = intensity_;
        light.attenuation = {0.0f, 0.0f, 1.0f};
        return light;
    };
    return {
        {"sample",
         "intensity in [0, 1e30], the lamp 0 or [1e-15, 1e18] away, 1 / d²: its irradiance",
         "[0, 1e18]",
         0,
         1.000001e18,
         true,
         6e-7,
         {intensity, distance},
         [=](const Inputs& x) {
             return sample(lamp(x[0]), {0.0f, -x[1], 0.0f}).irradiance.y;
         },
         [](const Inputs& x) {
             const Real d = std::max(x[1], 1e-15f);
             return std::min(x[0] / (d * d), Real{kMostIrradiance} * std::min(x[0], 1.0f));
         }},
        formula_of({"sample",
                    "the lamp in the point, 1e-38 or [1e-15, 1e18] away: its l",
                    "[0, 1]",
                    1,
                    false,
                    2e-7,
                    {{1e-15f, 1e18f, Spread::logarithmic, {1.0f}, {0.0f, 1e-38f}}},
                    [=](const Inputs& x) {
                        return sample(lamp(1.0f), {-x[0], 0.0f, 0.0f}).l;
                    },
                    [](const Inputs& x) { return Wide(x[0] < 1e-15f ? 0 : 1, 0, 0); }}),
        formula_of({"prepare",
                    "a direction whose components' largest is in [1e-30, 1e30]: the axis",
                    "[0, 1.0000002]",
                    1.0000002,
                    false,
                    1e-7,
                    {kHeight, kTurn, {1e-30f, 1e30f, Spread::logarithmic, {1.0f}}},
                    [](const Inputs& x) {
                        Light light;
                        light.direction = direction(x[0], x[1]) * x[2];
                        return prepare(light).axis;
                    },
                    [](const Inputs& x) { return glm::normalize(Wide(direction(x[0], x[1]) * x[2])); }}),
    };
}

/// A lamp of radiance 1 at the origin, 1 / d².
LightSetup lamp_in_origin(float cos_inner, float cos_outer) {
    LightSetup light;
    light.radiance = glm::vec3(1.0f);
    light.attenuation = {0.0f, 0.0f, 1.0f};
    light.axis = {0.0f, 0.0f, -1.0f};
    light.cos_inner = cos_inner;
    light.cos_outer = cos_outer;
    return light;
}

std::vector<Formula> light_samples() {
    const Axis far_away{1e-15f, 1e18f, Spread::logarithmic, {1.0f}};
    const auto place = [](const Inputs& x) { return direction(x[0], x[1]) * x[2]; };
    const auto exact_weight = [=](const Inputs& x) {
        const Wide p(place(x));
        return std::min(1 / glm::dot(p, p), Real{lamp_in_origin(1.0f, 0.0f).most_weight});
    };
    return {
        formula_of({"sample_point",
                    "distance in [1e-15, 1e18]: its l",
                    "[0, 1.0000004]",
                    1.0000004,
                    false,
                    4e-7,
                    {kHeight, kTurn, far_away},
                    [=](const Inputs& x) { return sample_point(lamp_in_origin(1.0f, 0.0f), place(x)).l; },
                    [=](const Inputs& x) { return -glm::normalize(Wide(place(x))); }}),
        {"sample_point",
         "distance in [1e-15, 1e18], 1 / d²: its irradiance",
         "[0, 1e18]",
         0,
         1.000001e18,
         true,
         6e-7,
         {kHeight, kTurn, far_away},
         [=](const Inputs& x) { return sample_point(lamp_in_origin(1.0f, 0.0f), place(x)).irradiance.x; },
         exact_weight},
        {"sample_spot",
         "distance in [0.5, 2], cones of 45° and 90°: its irradiance",
         "[0, 4]",
         0,
         4.00001,
         false,
         4e-6,
         {kHeight, kTurn, {0.5f, 2.0f, Spread::logarithmic, {1.0f}}},
         [=](const Inputs& x) { return sample_spot(lamp_in_origin(0.70710678f, 0.0f), place(x)).irradiance.x; },
         [=](const Inputs& x) {
             const Real t = std::clamp(-glm::normalize(Wide(place(x))).z / Real{0.70710678f}, Real{0}, Real{1});
             return exact_weight(x) * t * t * (3 - 2 * t);
         }},
        formula_of({"sample_directional",
                    "axis unit: its l",
                    "[0, 1.0000004]",
                    1.0000004,
                    false,
                    0,
                    {kHeight, kTurn},
                    [](const Inputs& x) {
                        LightSetup light;
                        light.axis = direction(x[0], x[1]);
                        return sample_directional(light).l;
                    },
                    [](const Inputs& x) { return -Wide(direction(x[0], x[1])); }}),
    };
}

std::vector<Formula> fog_formulas() {
    const Axis far_away{1e-15f, 1e18f, Spread::logarithmic, {1.0f, 100.0f, 1e8f}, {0.0f, kInfinity}};
    const Axis end{1e-15f, 1e18f, Spread::logarithmic, {1.0f, 100.0f}, {0.0f}};
    const Axis near_by{0.0f, 100.0f, Spread::even, {1e-8f, 1.0f}};
    const Axis density{0.0f, 1e30f, Spread::even, {1e-38f, 1e-8f, 0.1f, 1.0f}};
    return {
        {"fog_linear",
         "z in [0, inf], start and end in [0, 1e18], also the same or exchanged",
         "[0, 1]",
         0,
         1,
         false,
         3e-7,
         {far_away, end, end},
         [](const Inputs& x) { return fog_linear(x[0], x[1], x[2]); },
         [](const Inputs& x) {
             if (x[1] == x[2]) return x[0] < x[2] ? Real{1} : Real{0};
             return std::clamp((Real{x[2]} - x[0]) / (Real{x[2]} - x[1]), Real{0}, Real{1});
         }},
        {"fog_exp",
         "z in [0, inf), density in [0, 1e30]",
         "[0, 1]",
         0,
         1,
         false,
         3e-6,
         {near_by, density},
         [](const Inputs& x) { return fog_exp(x[0], x[1]); },
         [](const Inputs& x) { return std::exp(-Real{x[0]} * x[1]); }},
        {"fog_exp2",
         "z in [0, inf), density in [0, 1e30]",
         "[0, 1]",
         0,
         1,
         false,
         3e-6,
         {near_by, density},
         [](const Inputs& x) { return fog_exp2(x[0], x[1]); },
         [](const Inputs& x) { return std::exp(-(Real{x[0]} * x[1]) * (Real{x[0]} * x[1])); }},
        {"radial_distance",
         "0, or components whose largest is in [1e-15, 1e18]",
         "[0, 1.8e18]",
         0,
         1.8e18,
         true,
         2e-7,
         {kLength, kLength, kLength},
         [](const Inputs& x) {
             return radial_distance({x[0], x[1], x[2]}, glm::vec3(0.0f));
         },
         [](const Inputs& x) { return std::sqrt(Real{x[0]} * x[0] + Real{x[1]} * x[1] + Real{x[2]} * x[2]); }},
    };
}

}  // namespace

std::vector<Formula> formulas_of_lights() {
    return joined(joined(light_formulas(), lamp_formulas()), joined(light_samples(), fog_formulas()));
}

}  // namespace kreda::tests
