// The models that know a direction within the surface, for a batch: Ward's and Heidrich and Seidel's.
#pragma once

#include "lighting/batch/channels.hpp"
#include "lighting/material.hpp"

namespace kreda::lighting {

/// channels.t from the material's grain and channels.n.
void set_grain(int count, const PhongMaterial& material, LightingChannels& channels);

/// Add what the light in channels.l, channels.irradiance reflects to channels.diffuse and channels.specular. With
/// material.ward_alpha it reads channels.t, with diffuse_from_map channels.m_D.
void add_ward(int count, const PhongMaterial& material, bool diffuse_from_map, LightingChannels& channels);

/// The same. Reads channels.t.
void add_heidrich_seidel(int count, const PhongMaterial& material, bool diffuse_from_map, LightingChannels& channels);

/// Whether the material's model reads channels.t.
[[nodiscard]] bool needs_grain(const Material& material);

}  // namespace kreda::lighting
