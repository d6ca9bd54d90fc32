// Which materials are made of microfacets.
#pragma once

#include "lighting/material.hpp"

namespace kreda::scene {

/// Cook-Torrance; the other models reflect by formulas of their own.
[[nodiscard]] inline bool is_microfacet(const lighting::Material& material) {
    return material.model == lighting::ReflectionModel::cook_torrance;
}

}  // namespace kreda::scene
