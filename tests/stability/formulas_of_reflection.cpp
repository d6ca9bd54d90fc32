// The equations of lighting/reflection.hpp and normal_map.hpp as the lecture prints them, in long double.
#include <algorithm>
#include <cmath>

#include "lighting/normal_map.hpp"
#include "lighting/reflection.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

namespace {

using namespace kreda::lighting;

Real dot(const glm::vec3& a, const glm::vec3& b) {
    return Real{a.x} * b.x + Real{a.y} * b.y + Real{a.z} * b.z;
}

}  // namespace

std::vector<Formula> formulas_of_reflection() {
    const Axis sigma{0.0f, 1.0f, Spread::even, {1e-8f, 0.5f}};
    return {
        {"sigma_phong",
         "v, r unit to 3e-7",
         "[0, 1]",
         0,
         1,
         false,
         4e-7,
         {kHeight, kTurn, kHeight, kTurn},
         [](const Inputs& x) { return sigma_phong(direction(x[0], x[1]), direction(x[2], x[3])); },
         [](const Inputs& x) { return std::max(dot(direction(x[0], x[1]), direction(x[2], x[3])), Real{0}); }},
        {"sigma_blinn",
         "n, h unit to 3e-7",
         "[0, 1]",
         0,
         1,
         false,
         4e-7,
         {kHeight, kTurn, kHeight, kTurn},
         [](const Inputs& x) { return sigma_blinn(direction(x[0], x[1]), direction(x[2], x[3])); },
         [](const Inputs& x) { return std::max(dot(direction(x[0], x[1]), direction(x[2], x[3])), Real{0}); }},
        {"sigma_phong of v and v",
         "v unit to 3e-7",
         "[0, 1]",
         0,
         1,
         false,
         4e-7,
         {kHeight, kTurn},
         [](const Inputs& x) { return sigma_phong(direction(x[0], x[1]), direction(x[0], x[1])); },
         [](const Inputs&) { return Real{1}; }},
        {"highlight_of",
         "Sigma in [0, 1], shininess in [0, 1e9]",
         "[0, 1]",
         0,
         1,
         false,
         1e-6,
         {sigma, {1e-3f, 1e9f, Spread::logarithmic, {1.0f, 64.0f, 1e3f, 1e6f}, {0.0f}}},
         [](const Inputs& x) {
             PhongMaterial m;
             m.shininess = x[1];
             return highlight_of(x[0], 1.0f, m);
         },
         [](const Inputs& x) { return std::pow(Real{x[0]}, Real{x[1]}); }},
        {"normal_component",
         "stored in [0, 1], 8 bits",
         "[-1, 1]",
         -1,
         1,
         false,
         3e-7,
         {sigma},
         [](const Inputs& x) { return normal_component(x[0], 8); },
         [](const Inputs& x) { return std::max((x[0] - 128 / 255.0L) / (127 / 255.0L), -1.0L); }},
    };
}

}  // namespace kreda::tests
