// The distributions of facets, lighting/microfacet.hpp's D, as the papers print them, in long double.
#include <algorithm>
#include <cmath>

#include "tests/stability/exact_facets.hpp"

namespace kreda::tests {

namespace {

using namespace kreda::lighting;

Real ggx(Real c, Real s2, Real alpha) {
    const Real q = s2 + c * c * alpha * alpha;
    return alpha * alpha / (kPi * q * q);
}

/// The Gaussian's integral over the hemisphere in u = theta / m, up to where exp(-u²) is nothing: five points of Gauss
/// and Legendre in each of twelve parts.
Real exact_normalizer(Real m) {
    constexpr Real kNodes[] = {-0.9061798459386640L, -0.5384693101056831L, 0, 0.5384693101056831L, 0.9061798459386640L};
    constexpr Real kWeights[] = {0.2369268850561891L, 0.4786286704993665L, 0.5688888888888889L, 0.4786286704993665L,
                                 0.2369268850561891L};
    constexpr int kParts = 12;
    const Real half = std::min(kPi / 2 / m, Real{7}) / kParts / 2;
    Real sum = 0;
    for (int part = 0; part < kParts; ++part) {
        for (int i = 0; i < 5; ++i) {
            const Real u = half * (2 * part + 1 + kNodes[i]);
            sum += kWeights[i] * std::exp(-u * u) * std::sin(2 * u * m) / 2;
        }
    }
    return 2 * kPi * m * sum * half;
}

std::vector<Formula> distributions() {
    const std::string domain = "theta_h in [0, 90°), alpha in [0.002, 1]";
    return {
        {"ggx_distribution",
         domain,
         "[0, 8e4]",
         0,
         8e4,
         true,
         1e-6,
         {kAngle, kAlpha},
         [](const Inputs& x) { return ggx_distribution(half_of(x[0]).c, half_of(x[0]).s2, x[1]); },
         [](const Inputs& x) { return ggx(half_of(x[0]).c, half_of(x[0]).s2, x[1]); }},
        {"beckmann_distribution",
         domain,
         "[0, 8e4]",
         0,
         8e4,
         true,
         1e-4,
         {kAngle, kAlpha},
         [](const Inputs& x) { return beckmann_distribution(half_of(x[0]).c, half_of(x[0]).s2, x[1]); },
         [](const Inputs& x) { return exact_beckmann(half_of(x[0]).c, half_of(x[0]).s2, x[1]); },
         1e-30},
        {"blinn_phong_distribution",
         domain,
         "[0, 8e4]",
         0,
         8e4,
         true,
         1e-4,
         {kAngle, kAlpha},
         [](const Inputs& x) { return blinn_phong_distribution(half_of(x[0]).c, half_of(x[0]).s2, x[1]); },
         [](const Inputs& x) {
             const Real n = 2 / (Real{x[1]} * x[1]) - 2, s2 = half_of(x[0]).s2,
                        c2 = Real{half_of(x[0]).c} * half_of(x[0]).c;
             const Real log_c = s2 < Real(0.25) ? std::log1p(-s2) : std::log(c2);
             return (n + 2) / (2 * kPi) * std::exp(n / 2 * log_c);
         },
         1e-30},
        {"squared_angle",
         "theta in [0, 90°)",
         "[0, 2.468]",
         0,
         2.468,
         false,
         1e-6,
         {kAngle},
         [](const Inputs& x) { return squared_angle(half_of(x[0]).c, half_of(x[0]).s2); },
         [](const Inputs& x) { return Real{x[0]} * x[0]; }},
        {"log_one_minus",
         "sin² of theta in [0, 90°)",
         "[-26, 0]",
         -26,
         0,
         true,
         2.5e-7,
         {kAngle},
         [](const Inputs& x) {
             const Half h = half_of(x[0]);
             return log_one_minus(h.s2, h.c * h.c);
         },
         [](const Inputs& x) {
             const Half h = half_of(x[0]);
             return h.s2 < 0.25f ? std::log1p(-Real{h.s2}) : std::log(Real{h.c} * h.c);
         }},
    };
}

/// What the formulas above are made of.
std::vector<Formula> parts_of_distributions() {
    const auto exponent = [](const Inputs& x) {
        const Half h = half_of(x[0]);
        return -h.s2 / (Real{h.c} * h.c * x[1] * x[1]);
    };
    return {
        {"beckmann_exponent",
         "theta_h in [0, 90°), alpha in [0.002, 1]",
         "[-2.5e17, 0]",
         -2.5e17,
         0,
         true,
         5e-7,
         {kAngle, kAlpha},
         [](const Inputs& x) { return beckmann_exponent(half_of(x[0]).c, half_of(x[0]).s2, x[1]); },
         exponent},
        {"gaussian_normalizer",
         "m in [0.002, 1]",
         "[1.2e-5, 1.8]",
         1.2e-5,
         1.8,
         true,
         4e-6,
         {kAlpha},
         [](const Inputs& x) { return gaussian_normalizer(x[0]); },
         [](const Inputs& x) { return exact_normalizer(x[0]); }},
        {"gaussian_distribution",
         "theta_h in [0, 90°), alpha in [0.002, 1]",
         "[0, 8e4]",
         0,
         8e4,
         true,
         1e-4,
         {kAngle, kAlpha},
         [](const Inputs& x) { return gaussian_distribution(half_of(x[0]).c, half_of(x[0]).s2, x[1]); },
         [](const Inputs& x) {
             const Real angle = std::atan2(std::sqrt(Real{half_of(x[0]).s2}), Real{half_of(x[0]).c});
             return std::exp(-angle * angle / (Real{x[1]} * x[1])) / exact_normalizer(x[1]);
         },
         1e-30},
    };
}

}  // namespace

std::vector<Formula> formulas_of_distributions() {
    return joined(distributions(), parts_of_distributions());
}

}  // namespace kreda::tests
