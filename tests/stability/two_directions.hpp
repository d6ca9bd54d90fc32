// What a model of reflection is given: n upwards, l and v anywhere, a material.
#pragma once

#include <algorithm>

#include "lighting/material.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

inline const glm::vec3 kUp{0.0f, 0.0f, 1.0f};
inline const std::vector<Axis> kTwoDirections = {kHeight, kTurn, kHeight, kTurn};

/// l and v of the first four inputs.
inline glm::vec3 l_of(const Inputs& x) {
    return direction(x[0], x[1]);
}
inline glm::vec3 v_of(const Inputs& x) {
    return direction(x[2], x[3]);
}

inline Real positive(Real x) {
    return std::max(x, Real{0});
}

/// What is shorter than 1e-15 has no direction: it comes out shorter than 1, as in float.
inline Wide wide_unit(const Wide& v) {
    return v / std::max(glm::length(v), Real{1e-15f});
}

inline lighting::PhongMaterial shiny(float shininess) {
    lighting::PhongMaterial m;
    m.diffuse = glm::vec3(0.75f);
    m.specular = glm::vec3(0.5f);
    m.shininess = shininess;
    return m;
}

}  // namespace kreda::tests
