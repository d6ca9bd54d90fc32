// 44_materials: one ball, its maps added one after another: albedo, metallic, roughness, normal; and what they hold.
// Page docs/44_materials.md | After 17_textures | New: read_maps(), bend_normal(), maps = "folder/*.png"
// Break at: bend_normal | Look at: m, frame.t, frame.b, tilt | Try: normal_map_y "down", texture_filter "nearest"
#include <string>

#include "examples/example.hpp"
#include "examples/lit_scene.hpp"
#include "examples/view_panels.hpp"
#include "lighting/batch/maps.hpp"
#include "scene/render/render.hpp"

using namespace kreda;
using namespace kreda::examples;
using lighting::Map;
using lighting::MaterialMaps;

namespace {

/// The scene with the first `count` of the maps; the constants hold for the others.
Image draw_with(scene::Scene scene, std::initializer_list<Map MaterialMaps::*> kept, const char* caption, int height) {
    const MaterialMaps all = scene.materials[0].maps;
    MaterialMaps& maps = scene.materials[0].maps;
    for (const lighting::MapUse& use : lighting::map_uses()) maps.*use.map = {};
    for (Map MaterialMaps::*map : kept) maps.*map = all.*map;
    Image picture = shown(scene, scene::render(scene));
    draw_caption(picture, caption, text_scale(height));
    return picture;
}

void draw(const Options& options) {
    const int height = options.height;
    const glm::ivec2 size = panel_size(options.width, height, 3, 2);
    scene::Scene scene = read_scene(options, KREDA_EXAMPLE_FOLDER "/tiles.toml");
    scene.image.width = size.x;
    scene.image.height = size.y;

    using M = MaterialMaps;
    save(options, "materials",
         montage(options.width, height, 3,
                 {draw_with(scene, {}, "constants", height), draw_with(scene, {&M::albedo}, "+ albedo", height),
                  draw_with(scene, {&M::albedo, &M::metallic}, "+ metallic", height),
                  draw_with(scene, {&M::albedo, &M::metallic, &M::roughness}, "+ roughness", height),
                  draw_with(scene, {&M::albedo, &M::metallic, &M::roughness, &M::normal}, "+ normal", height),
                  view_panels(scene, {{"normal", "normal"}}, height)[0]}));
    save(options, "maps",
         montage(options.width, height, 3,
                 view_panels(scene,
                             {{"albedo", "albedo"},
                              {"metallic", "metallic"},
                              {"roughness", "roughness"},
                              {"ao", "ao"},
                              {"normal_map", "normal_map"},
                              {"uv", "uv"}},
                             height)));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "44_materials", draw);
}
