#include "lighting/energy.hpp"

#include <vector>

#include <glm/geometric.hpp>

#include "lighting/cook_torrance.hpp"
#include "lighting/importance.hpp"

namespace kreda::lighting {

namespace {

constexpr int kAzimuths = 12;  ///< over half a turn: the other half mirrors it
constexpr int kHeights = 32;

using glm::dvec3;

/// E(mu) = mean of f (n.l) / p over facets m spread by visible_facet, l = v mirrored in m.   With GGX and Smith's G_1:
///   f (n.l) / p = (D / D_GGX) 4 (n.l)(n.v) V / G_1(v)
/// The BRDF map (lighting/environment/brdf_map.cpp) is the same mean: by another set of facets, in float and in lanes,
/// for what an image lights (LitBy), and split by F's power. This one is in double and costs a hundredth; a material
/// that asks for energy_compensation under lamps alone needs no map. To make them one would change the bits of either.
double albedo(Distribution distribution, Geometry geometry, double mu, float roughness,
              const std::array<double, kAzimuths>& cosines, const std::array<double, kAzimuths>& sines) {
    const float alpha = alpha_from_roughness(roughness);
    const dvec3 v{std::sqrt((1.0 - mu) * (1.0 + mu)), 0.0, mu};
    const double G_1 = smith_g1(static_cast<float>(mu), alpha);
    double sum = 0.0;
    for (int j = 0; j < kHeights; ++j) {
        const double w = (j + 0.5) / kHeights;
        const double weight = 2.0 * w;  // u = 1 - w^2: more points where u nears 1 and the facets are steep
        for (int i = 0; i < kAzimuths; ++i) {
            const dvec3 m = visible_facet<double>(v, alpha, cosines[i], sines[i], 1.0 - w * w);
            const double v_dot_m = glm::dot(v, m);
            const double n_dot_l = 2.0 * v_dot_m * m.z - v.z;
            if (n_dot_l <= 0.0) continue;
            const MicrofacetAngles angles{static_cast<float>(n_dot_l), static_cast<float>(mu), static_cast<float>(m.z),
                                          static_cast<float>(v_dot_m), static_cast<float>(m.x * m.x + m.y * m.y)};
            const double V = visibility_term(geometry, angles, alpha, roughness);
            const double D_by_ggx = distribution == Distribution::ggx
                                        ? 1.0
                                        : distribution_term(distribution, angles, alpha) /
                                              distribution_term(Distribution::ggx, angles, alpha);
            sum += weight * D_by_ggx * 4.0 * n_dot_l * mu * V / G_1;
        }
    }
    return sum / (kHeights * kAzimuths);
}

/// E_avg = 2 int E mu dmu = 4 int E s^3 ds with mu = s^2, by Simpson's rule over the nodes.
double average(const float* E) {
    double sum = 0.0;
    for (int i = 0; i < kEnergyNodes; ++i) {
        const double s = static_cast<double>(i) / (kEnergyNodes - 1);
        const double weight = i == 0 || i == kEnergyNodes - 1 ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
        sum += weight * 4.0 * s * s * s * E[i];
    }
    return sum / (3.0 * (kEnergyNodes - 1));
}

}  // namespace

EnergyTable compute_energy_table(Distribution distribution, Geometry geometry) {
    constexpr double kPi = 3.14159265358979323846;
    std::array<double, kAzimuths> cosines, sines;
    for (int i = 0; i < kAzimuths; ++i) {
        const double phi = kPi * (i + 0.5) / kAzimuths;
        cosines[i] = std::cos(phi);
        sines[i] = std::sin(phi);
    }
    EnergyTable table;
    for (int j = 0; j < kEnergyNodes; ++j) {
        const float roughness = static_cast<float>(j) / (kEnergyNodes - 1);
        float* row = &table.E[static_cast<std::size_t>(j) * kEnergyNodes];
        for (int i = 0; i < kEnergyNodes; ++i) {
            const double s = static_cast<double>(i) / (kEnergyNodes - 1);
            const double mu = s * s > 1e-4 ? s * s : 1e-4;  // E has a limit at 0, its quadrature has not
            const double E = albedo(distribution, geometry, mu, roughness, cosines, sines);
            row[i] = static_cast<float>(E < 1.0 ? E : 1.0);  // the sum of 384 points may exceed 1 by 1 %
        }
        table.E_avg[static_cast<std::size_t>(j)] = static_cast<float>(average(row));
    }
    return table;
}

}  // namespace kreda::lighting
