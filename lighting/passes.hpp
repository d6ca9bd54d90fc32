// Lighting a batch of points: one pass after another, each a loop over one formula, each leaving a named channel.
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "lighting/channels.hpp"
#include "lighting/cook_torrance.hpp"
#include "lighting/fog.hpp"
#include "lighting/light.hpp"
#include "lighting/material.hpp"
#include "raster/fragments.hpp"

namespace kreda::lighting {

/// A material made ready for a frame: what its model computes once.
struct MaterialSetup {
    Material material;
    CookTorranceSetup cook_torrance;  ///< only for model = cook_torrance
};

[[nodiscard]] MaterialSetup prepare(const Material& material);

/// What is the same for all points of a frame.
struct LightingSetup {
    glm::vec3 eye{0.0f};               ///< world space
    glm::vec3 forward{0.0f};           ///< unit, into the scene, world space
    bool orthographic = false;         ///< then v is the same everywhere: -forward
    glm::vec3 ambient{0.0f};           ///< s_A
    std::span<const LightSetup> lights;
    Fog fog;
};

/// The lecture's equation for all points of the batch:  radiance = ambient + diffuse + specular.
/// Reads fragments.position and fragments.normal.
void light_batch(const raster::Fragments& fragments, const MaterialSetup& material, const LightingSetup& setup,
                 LightingChannels& channels);

/// Instead of light_batch where the points were lit before (at vertices, once a triangle): radiance = fragments.color.
void copy_color(const raster::Fragments& fragments, LightingChannels& channels);

/// The fog factor of each point from its position.
void fog_factors(const raster::Fragments& fragments, const LightingSetup& setup, LightingChannels& channels);

/// Instead of fog_factors where the factor was computed at the vertices: f = fragments.fog.
void copy_fog(const raster::Fragments& fragments, LightingChannels& channels);

/// radiance = f radiance + (1 - f) fog colour.
void apply_fog(int count, const glm::vec3& fog_color, LightingChannels& channels);

}  // namespace kreda::lighting
