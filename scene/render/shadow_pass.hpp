// Shadows while a frame is drawn: first what each light sees, then for each batch of points what is in shadow. The pass
// build_shadow() draws the map, or builds the tree, of one light, for methods that answer point by point; those that
// answer for a whole frame have scene/render/frame_shadows.hpp.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lighting/batch/channels.hpp"
#include "raster/fragments.hpp"
#include "scene/render/frame.hpp"
#include "shadows/exact.hpp"
#include "shadows/shadow_map.hpp"

namespace kreda::scene {

/// The memory of one light's shadows; kept from frame to frame.
struct ShadowMemory {
    shadows::ShadowMap map;
    shadows::ExactShadow exact;
    bool is_exact_ready = false;
    std::vector<float> factor;  ///< of every sample of the picture, by methods that find all at once
    std::string inputs;         ///< of the pass that left the map or the tree; empty: there is none
    std::vector<std::shared_ptr<const raster::Mesh>> meshes;  ///< that the inputs name
};

/// channels.shadow at every point for the light of that number, counted among those that are on. False (and nothing is
/// written) if it casts none.
bool set_shadow(const Frame& frame, int light_that_is_on, const raster::Fragments& points,
                lighting::LightingChannels& channels);

}  // namespace kreda::scene
