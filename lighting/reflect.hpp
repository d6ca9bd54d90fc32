// What one lamp adds at one point, whatever the reflection model: the whole formula, in one call.
//
// A batch of one point, which is what a debugger stops at and `kreda explain` explains, runs reflect(). A larger batch
// runs the same small functions as passes, each a loop that leaves a channel (lighting/batch/passes.cpp). Both give the
// same bits, for every model and every choice of D, V and F (tested).
#pragma once

#include <glm/vec3.hpp>

#include "lighting/cook_torrance.hpp"
#include "lighting/material.hpp"
#include "lighting/reflection.hpp"

namespace kreda::lighting {

/// A material at one point of a surface, its maps read: what the models' formulas call m.
struct PointMaterial {
    ReflectionModel model = ReflectionModel::blinn_phong;  ///< decides which of the quantities count
    PhongMaterial phong;                       ///< all models but cook_torrance; m_D is the map's where there is one
    const CookTorranceSetup* setup = nullptr;  ///< cook_torrance: constants, D, V and F
    MicrofacetSurface surface;                 ///< cook_torrance: what may vary from point to point
};

/// What the surface reflects of one lamp, before the lamp's colour.   n, l, v unit, away from the surface, world space
[[nodiscard]] ReflectedTerms reflect(const PointMaterial& material, const glm::vec3& n, const glm::vec3& l,
                                     const glm::vec3& v);

}  // namespace kreda::lighting
