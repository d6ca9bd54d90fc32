// 60_depth_from_the_light: what the sun sees, and the depth test repeated from there.
// Page docs/60_depth_from_the_light.md | After 11_z_buffer | New: draw_shadow_map(), shadow_factors()
// Break at: map_point_parallel | Look at: point.u, point.v, point.distance | Try: shadow.size 64
#include <algorithm>

#include "examples/example.hpp"
#include "examples/table_scene.hpp"
#include "scene/render.hpp"
#include "scene/shadow_pass.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

scene::Scene make_scene(glm::ivec2 size) {
    scene::Scene scene = table_scene(size);
    scene.lights = {directional_light({-1.0f, -1.1f, -0.6f})};
    scene.lights[0].shadow = true;
    scene.shadow.method = shadows::ShadowMethod::map;
    scene.shadow.size = 512;
    return scene;
}

/// The map, shrunk to a square in the middle of a panel: near is dark, and white is where nothing casts.
Image map_panel(const shadows::ShadowMap& map, glm::ivec2 size) {
    const Image picture = shadow_map_picture(map);
    const int side = std::min(size.x, size.y);
    std::vector<float> grey;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const float depth = picture.at(0, x * picture.width / side, y * picture.height / side);
            grey.push_back(depth < 1.0f ? 0.7f * depth * depth + 0.02f : 1.0f);
        }
    }
    Image panel = make_board(size.x, size.y);
    paste(panel, grey_image(side, side, grey), (size.x - side) / 2, 0);
    return panel;
}

void draw(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 2);
    const scene::Scene scene = make_scene(size);
    scene::Scene unshadowed = scene;
    unshadowed.lights[0].shadow = false;

    scene::RenderBuffers buffers;
    render(scene, make_plan(scene, {scene::find_view("shadow")}), buffers);
    std::vector<Image> panels = {scene::render(unshadowed), map_panel(buffers.shadows[0].map, size),
                                 grey_image(size.x, size.y, buffers.views[0].values), buffers.film};
    const char* const captions[] = {"lit, no shadows", "distances the sun sees", "shadow factor", "with shadows"};
    for (std::size_t i = 0; i < panels.size(); ++i) draw_caption(panels[i], captions[i], text_scale(options.height));
    save(options, "steps", montage(options.width, options.height, 2, panels));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "60_depth_from_the_light", draw);
}
