// 63_soft_shadows: a light with a width; umbra and penumbra grow with the distance from what casts.
// Page docs/63_soft_shadows.md | After 62_pcf | New: find_blockers(), filter_penumbra(), half_cone()
// Break at: find_blockers | Look at: setup, cells | Try: light_size 0.5
#include <algorithm>

#include "examples/example.hpp"
#include "examples/geometry_drawings.hpp"
#include "examples/table_scene.hpp"
#include "scene/render/render.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

scene::Scene make_scene(glm::ivec2 size, int samples, float light_size) {
    scene::Scene scene = sunny_table(size, samples);
    scene.shadow.filter = light_size > 0.0f ? shadows::ShadowFilter::pcss : shadows::ShadowFilter::none;
    scene.shadow.light_size = light_size;
    return scene;
}

/// The width of the penumbra where there is one: the wider, the brighter.
Image penumbra_panel(glm::ivec2 size, int samples, float light_size) {
    const scene::Scene scene = make_scene(size, samples, light_size);
    scene::RenderBuffers buffers;
    render(scene, make_plan(scene, {scene::find_view("penumbra")}), buffers);
    auto values = buffers.views[0].values;
    for (float& value : values) value = std::min(value / 0.3f, 1.0f);
    return grey_image(size.x, size.y, values);
}

void draw(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 2);
    const Image penumbra = penumbra_panel(size, options.samples, 0.2f);
    save_panels(options, "soft", 2,
                {captioned(make_scene(size, options.samples, 0.0f), "no width"),
                 captioned(make_scene(size, options.samples, 0.05f), "width 0.05"),
                 captioned(make_scene(size, options.samples, 0.2f), "width 0.2"),
                 {penumbra, "width of the penumbra"}});
    save_panel(options, "geometry", penumbra_geometry({options.width, options.height}));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "63_soft_shadows", draw);
}
