// Fresnel's equations as the papers print them, in long double, and the inputs that they take.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>

#include "tests/stability/formula_sweep.hpp"

namespace kreda::tests {

inline const Axis kRatio{0.001f, 1000.0f, Spread::logarithmic, {0.1f, 0.2f, 1.0f, 1.5f}};
inline const Axis kF0{0.0f, 1.0f, Spread::even, {1e-8f, 0.04f, 0.5f}};
/// What is smaller than 1e-12 stands for 0.
inline const Axis kExtinction{0.0f, 1000.0f, Spread::even, {1e-8f, 1e-4f, 1.0f, 10.0f, 100.0f}};

inline float extinction(float k) {
    return k < 1e-12f ? 0.0f : k;
}

/// Fresnel's equations with a complex index: the textbook form, with tan and arcsine nowhere.
inline Real exact_fresnel(Real c, Real n, Real k) {
    using Complex = std::complex<Real>;
    const Complex m(n, k);
    const Complex root = std::sqrt((m - Real{1}) * (m + Real{1}) + Complex(c * c));  // m cos theta_t
    const Complex below_s = c + root, below_p = m * m * c + root;
    if (std::abs(below_s) == 0 || std::abs(below_p) == 0) return 0;  // n = 1 at 90 degrees
    return (std::norm((c - root) / below_s) + std::norm((m * m * c - root) / below_p)) / 2;
}

inline Real exact_refracted(Real c, Real n) {
    const Real cos2 = ((n - 1) * (n + 1) + c * c) / (n * n);
    return std::sqrt(std::max(cos2, Real{0}));
}

/// Equation (14): Schlick's F.
inline Real f14(Real c, Real f0) {
    return f0 + (1 - f0) * std::pow(1 - c, Real{5});
}

}  // namespace kreda::tests
