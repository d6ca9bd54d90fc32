// 60_depth_from_the_light: what the sun sees, and the depth test repeated from there.
// Page docs/60_depth_from_the_light.md | After 11_z_buffer | New: draw_shadow_map(), shadow_factors()
// Break at: map_point_parallel | Look at: point.u, point.v, point.distance | Try: shadow.size 64
#include <vector>

#include "examples/example.hpp"
#include "examples/table_scene.hpp"
#include "scene/render/light_depth.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

scene::Scene make_scene(glm::ivec2 size, int samples) {
    scene::Scene scene = sunny_table(size, samples);
    scene.shadow.size = 512;
    return scene;
}

/// The map, shrunk to a square in the middle of a panel: near is dark, and white is where nothing casts.
Image map_panel(const scene::RenderBuffers& buffers, const scene::Scene& scene) {
    const Image picture = picture_of(scene::light_depth_view(), light_depth(buffers), scene).encoded;
    std::vector<float> grey;
    for (const float depth : picture.values) grey.push_back(depth < 1.0f ? 0.7f * depth * depth + 0.02f : 1.0f);
    return fit(grey_image(picture.width, picture.height, grey), scene.image.width, scene.image.height);
}

/// Why a pixel is dark: blue where the surface faces away from the sun, its own shadow; orange where something else
/// keeps the sun off, a cast shadow.
Image kinds_of_shadow(scene::Scene scene) {
    scene.image.background = glm::vec3(0.0f);
    for (lighting::Material& material : scene.materials) material = matte(kDust);
    scene::RenderBuffers buffers;
    render(scene, make_plan(scene, {scene::find_view("shadow"), scene::find_view("n_dot_l")}), buffers);
    Image image = buffers.film;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const bool is_empty = image.rgb(x, y) == scene.image.background;
            const float lit = buffers.views[0].at(0, x, y), n_dot_l = buffers.views[1].at(0, x, y);
            if (is_empty) {
                image.set_rgb(x, y, kBoard);
            } else if (n_dot_l <= 0.0f) {
                image.set_rgb(x, y, 0.7f * kBlue);
            } else if (lit <= 0.5f) {
                image.set_rgb(x, y, kOrange);
            }
        }
    }
    return image;
}

void draw(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 2);
    const scene::Scene scene = make_scene(size, options.samples);
    scene::Scene unshadowed = scene;
    unshadowed.lights[0].shadow = false;

    scene::RenderBuffers buffers;
    render(scene, make_plan(scene, {scene::find_view("shadow")}), buffers);
    const std::vector<Image> images = {scene::render(unshadowed), map_panel(buffers, scene),
                                       grey_image(size.x, size.y, buffers.views[0].values), buffers.film};
    save_panels(options, "steps", 2,
                with_captions(images, {"lit, no shadows", "distances the sun sees", "shadow factor", "with shadows"}));

    const Image kinds = averaged({options.width, options.height}, options.samples,
                                 [](glm::ivec2 fine) { return kinds_of_shadow(make_scene(fine, 1)); });
    save_panel(options, "kinds", {kinds, "blue: own shadow, orange: cast shadow"});
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "60_depth_from_the_light", draw);
}
