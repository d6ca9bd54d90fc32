// What facets are, in long double, and the inputs that the formulas of facets take.
#pragma once

#include <cmath>

#include "lighting/microfacet.hpp"
#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

inline const Axis kAlpha{lighting::kMinAlpha, 1.0f, Spread::logarithmic, {0.01f, 0.25f}};
inline const Axis kAngle{0.0f, 1.57079f, Spread::even, {1e-8f, 1e-4f, 0.002f, 0.785f, 1.57f}};

/// cos and sin^2 of an angle as floats: what the formulas are given.
struct Half {
    float c, s2;
};
inline Half half_of(float theta) {
    const Real c = std::cos(Real{theta}), s = std::sin(Real{theta});
    return {static_cast<float>(c), static_cast<float>(s * s)};
}

inline Real exact_beckmann(Real c, Real s2, Real alpha) {
    return std::exp(-s2 / (c * c * alpha * alpha)) / (kPi * alpha * alpha * c * c * c * c);
}

}  // namespace kreda::tests
