#include "tools/measure/brdf_quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace kreda::tools {

namespace {

/// Smith's Lambda of GGX.
double lambda(double cosine, double alpha) {
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * (1.0 - cosine * cosine) / (cosine * cosine)) - 1.0);
}

}  // namespace

lighting::BrdfTerms brdf_by_quadrature(double n_dot_v, double roughness, int steps) {
    const double alpha = std::max(roughness * roughness, 1e-4), sine = std::sqrt(1.0 - n_dot_v * n_dot_v);
    const double lambda_v = lambda(n_dot_v, alpha);
    const glm::dvec3 v(sine, 0.0, n_dot_v);
    const glm::dvec3 stretched = glm::normalize(glm::dvec3(alpha * v.x, 0.0, v.z));
    double A = 0.0, B = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double phi = std::numbers::pi * (i + 0.5) / steps;  // the other half is its mirror image
        for (int j = 0; j < steps; ++j) {
            const double t = (j + 0.5) / steps, u = t * t * (3.0 - 2.0 * t), du = 6.0 * t * (1.0 - t);
            const double z = (1.0 - u) * (1.0 + stretched.z) - stretched.z, r = std::sqrt(std::max(1.0 - z * z, 0.0));
            const glm::dvec3 h = glm::normalize(
                glm::dvec3(alpha * (r * std::cos(phi) + stretched.x), alpha * r * std::sin(phi), z + stretched.z));
            const double v_dot_h = glm::dot(v, h), n_dot_l = 2.0 * v_dot_h * h.z - v.z;
            if (n_dot_l <= 0.0) continue;
            const double weight = du * (1.0 + lambda_v) / (1.0 + lambda_v + lambda(n_dot_l, alpha));  // G_2 / G_1
            const double F_c = std::pow(1.0 - v_dot_h, 5.0);
            A += (1.0 - F_c) * weight;
            B += F_c * weight;
        }
    }
    const double count = static_cast<double>(steps) * steps;
    return {static_cast<float>(A / count), static_cast<float>(B / count), 0.0f};
}

}  // namespace kreda::tools
