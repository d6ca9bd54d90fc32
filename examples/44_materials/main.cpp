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
Panel draw_with(scene::Scene scene, std::initializer_list<Map MaterialMaps::*> kept, const char* caption) {
    const MaterialMaps all = scene.materials[0].maps;
    MaterialMaps& maps = scene.materials[0].maps;
    for (const lighting::MapUse& use : lighting::map_uses()) maps.*use.map = {};
    for (Map MaterialMaps::*map : kept) maps.*map = all.*map;
    return {shown(scene, scene::render(scene)), caption};
}

void draw(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 3, 2);
    scene::Scene scene = read_scene(options, KREDA_EXAMPLE_FOLDER "/tiles.toml");
    scene.image.width = size.x;
    scene.image.height = size.y;

    using M = MaterialMaps;
    save_panels(options, "materials", 3,
                {draw_with(scene, {}, "constants"), draw_with(scene, {&M::albedo}, "+ albedo"),
                 draw_with(scene, {&M::albedo, &M::metallic}, "+ metallic"),
                 draw_with(scene, {&M::albedo, &M::metallic, &M::roughness}, "+ roughness"),
                 draw_with(scene, {&M::albedo, &M::metallic, &M::roughness, &M::normal}, "+ normal"),
                 view_panels(scene, {{"normal", "normal"}})[0]});
    save_panels(options, "maps", 3,
                view_panels(scene, {{"albedo", "albedo"},
                                    {"metallic", "metallic"},
                                    {"roughness", "roughness"},
                                    {"ao", "ao"},
                                    {"normal_map", "normal_map"},
                                    {"uv", "uv"}}));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "44_materials", draw);
}
