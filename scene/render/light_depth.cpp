#include "scene/render/light_depth.hpp"

#include <limits>

#include "scene/render/shadow_pass.hpp"

namespace kreda::scene {

namespace {

bool has_map(const RenderPlan& plan, std::uint32_t) {
    return !plan.shadows.empty() && plan.shadows[0].map.settings.method == shadows::ShadowMethod::map;
}

}  // namespace

const View& light_depth_view() {
    static const View view{
        .name = "light_depth",
        .meaning =
            "the last shadow map: distance along the light's axis (parallel rays: from the first caster), white: "
            "nothing casts",
        .requires_what = "shadow.method = \"map\" and a light with shadow = true that falls on something seen",
        .components = 1,
        .scale = ViewScale::range,
        .needs = {},
        .wanted = {.radiance = true, .maps = true, .surface = true, .position = true},
        .holds = has_map,
        .value = nullptr,
        .background = std::numeric_limits<float>::infinity(),
    };
    return view;
}

bool is_light_depth(const View* view) {
    return view == &light_depth_view();
}

std::vector<const View*> known_views() {
    std::vector<const View*> views;
    for (const View& view : all_views()) views.push_back(&view);
    views.push_back(&light_depth_view());
    return views;
}

raster::Image light_depth(const RenderBuffers& buffers) {
    return map_distances(buffers.shadows.back().map);
}

}  // namespace kreda::scene
