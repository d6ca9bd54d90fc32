// Where reflected light goes: each reflection model as a function of two directions, for plots and for its energy.
#pragma once

#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "lighting/cook_torrance.hpp"
#include "lighting/material.hpp"

namespace kreda::tools {

/// A reflection model as the plots take it: grey, of one roughness.
struct LobeModel {
    std::string_view name;  ///< of its files, and on the command line
    std::string_view title;
    bool has_roughness = true;
    bool conserves = false;  ///< gives back no more light than it gets: reflectance() <= 1
    lighting::Material (*material)(float roughness) = nullptr;
};

/// All models but unlit, in the order of the lessons. Roughness r is alpha = r^2; the exponents of the lecture's models
/// follow it:   h = 2 / alpha^2 - 2   about the half vector, a quarter of that about the mirror direction.
[[nodiscard]] const std::vector<LobeModel>& lobe_models();

/// A model at one roughness, ready to reflect.
struct Reflector {
    lighting::Material material;
    lighting::CookTorranceSetup setup;  ///< cook_torrance
};
[[nodiscard]] Reflector make_reflector(const LobeModel& model, float roughness);

/// The BRDF  f(l, v)  [1/sr]  by lighting::reflect(): what leaves along v for each unit of irradiance that l brings. n
/// is +z; l, v unit, above the surface. The lecture's models leave 1/pi to the lamp: so much less is f of them here.
[[nodiscard]] double brdf(const Reflector& reflector, const glm::dvec3& l, const glm::dvec3& v);

/// A direction at theta from the normal +z, above the x axis; negative theta: on the other side of the normal.
[[nodiscard]] glm::dvec3 direction(double theta_deg, double phi_deg = 0.0);

/// Share of the light from l that is given back, to all sides:   R(l) = integral of f(l, v) (n.v) dv.
/// Midpoints of steps x 2 steps cells about the mirror direction, where lobes are narrow.     theta_deg in [0, 90)
[[nodiscard]] double reflectance(const Reflector& reflector, double theta_deg, int steps = 192);

}  // namespace kreda::tools
