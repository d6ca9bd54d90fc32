// What a light sees, as a picture: its shadow map. Named and encoded as a view is, but in the size of the map, so it is
// no channel of a pass and not among all_views().
#pragma once

#include <vector>

#include "scene/plan/views.hpp"
#include "scene/render/render.hpp"

namespace kreda::scene {

[[nodiscard]] const View& light_depth_view();
[[nodiscard]] bool is_light_depth(const View* view);

/// Everything that somebody may ask for by name: views of the picture's size, and what a light sees.
[[nodiscard]] std::vector<const View*> known_views();

/// The distances in the last shadow map of a frame (shadows/shadow_map.hpp, map_distances()); its plan must be able to
/// show light_depth_view().
[[nodiscard]] raster::Image light_depth(const RenderBuffers& buffers);

}  // namespace kreda::scene
