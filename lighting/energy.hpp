// The energy that a single bounce off microfacets loses, and Kulla and Conty's lobe that gives it back.
//
// E(mu) is the directional albedo for F = 1: the share of white light from all sides that a single bounce reflects
// toward a viewer with n.v = mu. The rest, 1 - E, hit another facet; D V F stops there. At roughness 1 that is 59 %.
#pragma once

#include <cmath>

#include <glm/vec3.hpp>

#include "lighting/material.hpp"
#include "lighting/tables.hpp"
#include "raster/scalar_math.hpp"

namespace kreda::lighting {

/// One table for one pair of D and G. 20 ms; the same bits on every machine.
[[nodiscard]] EnergyTable compute_energy_table(Distribution distribution, Geometry geometry);

/// Where a number in [0, 1] lies between nodes.
struct NodeInterval {
    int i;    ///< between node i and i + 1
    float t;  ///< share of node i + 1
};

/// The two nodes beside x in [0, 1], and how far x lies between them.
inline NodeInterval node_interval(float x) {
    const float position = raster::saturate(x) * static_cast<float>(kEnergyNodes - 1);
    const int truncated = static_cast<int>(position);
    const int i = truncated < kEnergyNodes - 2 ? truncated : kEnergyNodes - 2;
    return {i, position - static_cast<float>(i)};
}

/// E(mu) of a roughness, bilinear in sqrt(mu) and roughness.   mu = n.l or n.v in [0, 1].
inline float directional_albedo(const EnergyTable& table, float mu, float roughness) {
    const NodeInterval column = node_interval(std::sqrt(mu > 0.0f ? mu : 0.0f));
    const NodeInterval row = node_interval(roughness);
    const int first = row.i * kEnergyNodes + column.i;
    const float E_0 = raster::lerp(table.E[first], table.E[first + 1], column.t);
    const float E_1 = raster::lerp(table.E[first + kEnergyNodes], table.E[first + kEnergyNodes + 1], column.t);
    return raster::lerp(E_0, E_1, row.t);
}

/// E_avg = 2 int_0^1 E(mu) mu dmu of a roughness.
inline float average_albedo(const EnergyTable& table, float roughness) {
    const NodeInterval row = node_interval(roughness);
    return raster::lerp(table.E_avg[row.i], table.E_avg[row.i + 1], row.t);
}

/// The lobe of all further bounces, before colour   f_ms = (1 - E(n.l)) (1 - E(n.v)) / (pi (1 - E_avg))       [1/sr]
/// Kulla & Conty 2017, after Kelemen & Szirmay-Kalos 2001. With F = 1 the sum reflects exactly all light.
inline float multiple_scattering(float E_l, float E_v, float E_avg) {
    const float lost = 1.0f - E_avg;
    const float above = (1.0f - E_l) * (1.0f - E_v);
    return above * raster::kInvPi / (lost > 1e-6f ? lost : 1e-6f);
}

/// Its colour   F_ms = F_avg^2 E_avg / (1 - F_avg (1 - E_avg))                                       Kulla & Conty 2017
inline float multiple_scattering_color(float F_avg, float E_avg) {
    const float below = 1.0f - F_avg * (1.0f - E_avg);
    return F_avg * F_avg * E_avg / (below > 1e-6f ? below : 1e-6f);
}

/// F_avg = 2 int_0^1 F(mu) mu dmu of Schlick's F   = R_0 + (1 - R_0) / 21,   R_0 in [0, 1]
inline float average_schlick(float f0) {
    return f0 + (1.0f - f0) * (1.0f / 21.0f);
}

/// The same of F82   = R_0 + (1 - R_0) / 21 - b / 126,   b in [-20, 20]
inline float average_f82(float f0, float b) {
    return average_schlick(f0) - b * (1.0f / 126.0f);
}

/// F_ms of the three channels. f_avg_shift: what the average of the chosen F exceeds that of Schlick's by.
inline glm::vec3 multiple_scattering_color(const glm::vec3& f0, const glm::vec3& f_avg_shift, float E_avg) {
    return {multiple_scattering_color(average_schlick(f0.x) + f_avg_shift.x, E_avg),
            multiple_scattering_color(average_schlick(f0.y) + f_avg_shift.y, E_avg),
            multiple_scattering_color(average_schlick(f0.z) + f_avg_shift.z, E_avg)};
}

}  // namespace kreda::lighting
