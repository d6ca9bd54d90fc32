// Phong's model and Blinn's for a batch: the measure of reflection, its power, the terms; each a loop over one formula.
#pragma once

#include "lighting/batch/channels.hpp"
#include "lighting/material.hpp"

namespace kreda::lighting {

/// phong() or blinn_phong(), pass by pass: add what the light in channels.l, channels.n_dot_l, channels.irradiance
/// reflects to channels.diffuse and channels.specular. map: channels.m_D takes the place of the material's constant.
void add_highlights(int count, const Material& material, bool map, LightingChannels& channels);

}  // namespace kreda::lighting
