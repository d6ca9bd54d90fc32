// 44_materials: one ball, its maps added one after another: albedo, metallic, roughness, normal; and what they hold.
// Page docs/44_materials.md | After 17_textures | New: read_maps(), bend_normal(), maps = "folder/*.png"
// Break at: bend_normal | Look at: m, frame.t, frame.b, tilt | Try: normal_map_y "down", texture_filter "nearest"
#include <string>

#include "examples/example.hpp"
#include "examples/lit_scene.hpp"
#include "lighting/maps.hpp"
#include "raster/film.hpp"
#include "scene/render.hpp"
#include "scene/views.hpp"

using namespace kreda;
using namespace kreda::examples;
using lighting::Map;
using lighting::MaterialMaps;

namespace {

/// The picture as a display shows it, in linear RGB again: the scene has its own tone map.
Image shown(const scene::Scene& scene, const Image& radiance) {
    const scene::ImageSettings& image = scene.image;
    return develop(radiance, {image.exposure, image.tone_map, image.white, raster::Transfer::linear});
}

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

/// A channel of the render, as `kreda render --view` writes it.
Image draw_view(const scene::Scene& scene, const char* name, int height) {
    const scene::View& view = *scene::find_view(name);
    scene::RenderBuffers buffers;
    render(scene, make_plan(scene, {&view}), buffers);
    const Image encoded = picture_of(view, buffers.views[0], scene).encoded;
    Image picture = make_board(encoded.width, encoded.height);
    for (int y = 0; y < encoded.height; ++y) {
        for (int x = 0; x < encoded.width; ++x) {
            const glm::vec3 byte = encoded.rgb(x, y);
            picture.set_rgb(
                x, y,
                {raster::linear_from_srgb(byte.x), raster::linear_from_srgb(byte.y), raster::linear_from_srgb(byte.z)});
        }
    }
    draw_caption(picture, name, text_scale(height));
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
                  draw_view(scene, "normal", height)}));
    save(options, "maps",
         montage(options.width, height, 3,
                 {draw_view(scene, "albedo", height), draw_view(scene, "metallic", height),
                  draw_view(scene, "roughness", height), draw_view(scene, "ao", height),
                  draw_view(scene, "normal_map", height), draw_view(scene, "uv", height)}));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "44_materials", draw);
}
