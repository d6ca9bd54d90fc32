// Lighting a batch of points: one pass after another, each a loop over one formula, each leaving a named channel.
#pragma once

#include <glm/vec3.hpp>

#include "lighting/batch/channels.hpp"
#include "lighting/batch/setup.hpp"
#include "raster/fragments.hpp"

namespace kreda::lighting {

struct PointMaterial;

// The lecture's equation,  radiance = ambient + sum over lights of shadow (diffuse + specular),  is these in turn:
// start_surface; apply_maps where there are some; set_directions; add_environment where there is one; for each light
// sample_light, and where any_faces_light shadow_light (if it casts a shadow) and add_reflection; sum_terms.
// scene/render/shade.cpp runs them.

/// The material at every point as its constants say: ambient = s_A m_A + m_E; nothing reflected yet.
void start_surface(const MaterialSetup& material, const LightingSetup& setup, LightingChannels& channels);

/// What the maps say instead of the constants. Reads the fragments' u, v and their steps, as material.map_needs says.
void apply_maps(const raster::Fragments& fragments, const MaterialSetup& material, LightingChannels& channels);

/// What the lights will need: n, v, and what the model makes of them. Not for unlit materials. Reads
/// fragments.position, fragments.normal, and for normal maps the tangents.
void set_directions(const raster::Fragments& fragments, const MaterialSetup& material, const LightingSetup& setup,
                    LightingChannels& channels);

/// The three in turn, as far as the material needs them.
void start_lighting(const raster::Fragments& fragments, const MaterialSetup& material, const LightingSetup& setup,
                    LightingChannels& channels);

/// l, irradiance and n.l of one light at every point.
void sample_light(const raster::Fragments& fragments, const LightSetup& light, LightingChannels& channels);

/// Is that light worth adding here? False: it shines on the back of all points (n.l <= 0) and adds nothing.
[[nodiscard]] bool any_faces_light(int count, const LightingChannels& channels);

/// What a shadow leaves of that light:  irradiance = shadow x irradiance.
void shadow_light(int count, LightingChannels& channels);

/// The material at point i of a batch, its maps read.
[[nodiscard]] PointMaterial material_at(const MaterialSetup& material, const LightingChannels& channels, int i);

/// Whether the steps of the formula leave their channels (sigma, highlight, D, V, F and their angles).
enum class LeaveChannels {
    always,           ///< somebody looks at them: a view, a picture of a stage
    only_of_batches,  ///< a batch of one point runs reflect(), whole, and leaves 0 there
    only_radiance     ///< the same, and no light follows: a batch may leave the sum of the terms instead of them
};

/// Add what the material reflects of that light to diffuse and specular. The bits are the same either way.
void add_reflection(int count, const MaterialSetup& material, LeaveChannels leave, LightingChannels& channels);

/// radiance = ambient + diffuse + specular
void sum_terms(int count, LightingChannels& channels);

/// Instead of all that where the points were lit before (at vertices, once a triangle): radiance = fragments.color.
void copy_color(const raster::Fragments& fragments, LightingChannels& channels);

}  // namespace kreda::lighting
