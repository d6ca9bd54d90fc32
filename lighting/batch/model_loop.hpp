// The loop that the local models share: one formula over a batch, its m_D a constant or a map's.
#pragma once

#include "lighting/batch/add_light.hpp"
#include "lighting/batch/channels.hpp"
#include "lighting/material.hpp"

namespace kreda::lighting {

/// Add model(i, material), what the light in channels.l reflects at point i, to the sums. With `diffuse_from_map` the
/// material at point i has m_D = channels.m_D.
template <class Model>
inline void add_model(int lanes, PhongMaterial m, bool diffuse_from_map, LightingChannels& c, Model model) {
    with_adder(c, [&](auto add) {
        if (!diffuse_from_map) {
            for (int i = 0; i < lanes; ++i) add(i, model(i, m));
            return;
        }
        for (int i = 0; i < lanes; ++i) {
            PhongMaterial here = m;
            here.diffuse = c.m_D.at(i);
            add(i, model(i, here));
        }
    });
}

}  // namespace kreda::lighting
