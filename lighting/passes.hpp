// Lighting a batch of points: one pass after another, each a loop over one formula, each leaving a named channel.
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "lighting/fog.hpp"
#include "lighting/light.hpp"
#include "lighting/material.hpp"
#include "raster/fragments.hpp"

namespace kreda::lighting {

/// Every quantity of the lecture's equation at every point of a batch.
struct LightingChannels {
    raster::Channel3 n;           ///< unit normal
    raster::Channel3 v;           ///< unit, to the viewer
    raster::Channel3 l;           ///< unit, to the light that is being added
    raster::Channel3 irradiance;  ///< what that light sends, s(p)
    raster::Channel3 ambient;     ///< s_A m_A + m_E
    raster::Channel3 diffuse;     ///< sum of s m_D (l.n)
    raster::Channel3 specular;    ///< sum of s m_S Sigma^h
    raster::Channel fog;          ///< f
    raster::Channel3 radiance;    ///< what leaves toward the viewer: linear RGB
};

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
void light_batch(const raster::Fragments& fragments, const Material& material, const LightingSetup& setup,
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
