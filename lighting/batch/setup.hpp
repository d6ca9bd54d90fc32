// What is made ready once a frame for lighting in batches: of each material, and of all points together.
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "lighting/batch/maps.hpp"
#include "lighting/cook_torrance_setup.hpp"
#include "lighting/environment/environment.hpp"
#include "lighting/fog_settings.hpp"
#include "lighting/light.hpp"
#include "lighting/material.hpp"

namespace kreda::lighting {

/// A material made ready for a frame: what its model computes once.
struct MaterialSetup {
    Material material;                ///< as the scene has it
    CookTorranceSetup cook_torrance;  ///< only for model = cook_torrance
    MaterialMaps maps;                ///< those that its model reads
    MapNeeds map_needs;               ///< what reading `maps` asks of the fragments
};

/// What does not change from point to point of a material.
[[nodiscard]] MaterialSetup prepare(const Material& material);

/// What is the same for all points of a frame.
struct LightingSetup {
    glm::vec3 eye{0.0f};                 ///< world space
    glm::vec3 forward{0.0f};             ///< unit, into the scene, world space
    bool orthographic = false;           ///< then v is the same everywhere: -forward
    glm::vec3 ambient{0.0f};             ///< s_A
    std::span<const LightSetup> lights;  ///< those that the plan adds, in its order
    EnvironmentSetup environment;        ///< without maps: there is none
    Fog fog;                             ///< mode none: there is none
};

}  // namespace kreda::lighting
