// 70_hdr_tone_mapping: a lamp a hundred times as bright as the wall: what a display can show of it.
// Page docs/70_hdr_tone_mapping.md | After 22_phong_terms | New: FilmSettings, reinhard(), reinhard_extended()
// Break at: developed | Look at: radiance, scaled, exposed | Try: kWhite 2, kLamp 400
#include <algorithm>
#include <string>

#include "examples/lit_scene.hpp"
#include "examples/plots.hpp"
#include "scene/render/render.hpp"

using namespace kreda;
using namespace kreda::examples;
using raster::FilmSettings;
using raster::ToneMap;

namespace {

constexpr float kLamp = 30.0f;  // radiance of the lamp itself
constexpr float kWhite = 6.0f;  // extended Reinhard: what becomes white

/// A lamp that is seen, close to a wall, and pots from bright to dark.
scene::Scene make_scene(glm::ivec2 size) {
    scene::Scene scene = empty_scene(size);
    scene.image.background = glm::vec3(0.0f);
    scene.ambient = glm::vec3(0.12f, 0.14f, 0.2f);
    scene.camera.position = {0.5f, 1.1f, 5.6f};
    scene.camera.target = {0.25f, 0.5f, 0.0f};
    scene.camera.vertical_fov_deg = 30.0f;
    const glm::vec3 lamp(-1.15f, 1.2f, 0.35f);
    lighting::Material bulb;
    bulb.model = lighting::ReflectionModel::unlit;
    bulb.phong.diffuse = kLamp * glm::vec3(1.0f, 0.82f, 0.55f);
    const int ball = add_shape(scene, "sphere", 64, lamp, bulb);
    for (int axis = 0; axis < 3; ++axis) scene.objects[ball].world_from_object[axis] *= 0.16f;
    const int floor = add_shape(scene, "plane", 1, glm::vec3(0.0f), matte(srgb(0x9a8d7a)));
    scene.objects[floor].world_from_object[0][0] = scene.objects[floor].world_from_object[2][2] = 20.0f;
    const int wall = add_shape(scene, "plane", 1, {0.0f, 0.0f, -0.9f}, matte(srgb(0xb9b2a6)));
    scene.objects[wall].world_from_object = glm::mat4({20, 0, 0, 0}, {0, 0, 1, 0}, {0, -20, 0, 0}, {0, 0, -0.9f, 1});
    add_shape(scene, "teapot", 12, {-0.05f, 0.0f, -0.1f}, shiny(srgb(0x3f7f8f), 60.0f));
    const int knot = add_shape(scene, "torus_knot", 256, {1.55f, 0.45f, -0.2f}, shiny(srgb(0xb04a3a), 40.0f));
    for (int axis = 0; axis < 3; ++axis) scene.objects[knot].world_from_object[axis] *= 0.4f;
    lighting::Light light = point_light(lamp, 2.2f);
    light.color = {1.0f, 0.82f, 0.55f};
    light.attenuation = {0.0f, 0.0f, 1.0f};
    scene.lights = {light};
    return scene;
}

Panel shown(const Image& radiance, const FilmSettings& film, const std::string& caption) {
    Image image = develop(radiance, film);
    for (float& value : image.values) value = raster::linear_from_srgb(value);  // save() encodes again
    return {image, caption};
}

/// What the three operators make of radiance, on a logarithmic axis.
Plot curves() {
    Plot plot = empty_plot("radiance", "shown", true);
    plot.x_range = {0.1, 100.0};
    plot.y_range = {0.0, 1.05};
    plot.key = "outside top center horizontal";
    const auto add = [&](const char* name, auto shown) {
        plot.series.push_back(curve(
            name, *plot.x_range, [=](double L) { return shown(static_cast<float>(L)); }, true));
    };
    add("clamp", [](float L) { return std::min(L, 1.0f); });
    add("Reinhard", [](float L) { return raster::reinhard(L); });
    add("extended", [](float L) { return std::min(raster::reinhard_extended(L, kWhite), 1.0f); });
    return plot;
}

void draw(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 3, 2);
    const Image radiance = scene::render(make_scene(size));
    const std::vector<Panel> panels = {
        shown(radiance, {.exposure = 0.15f}, "exposure 0.15"),
        shown(radiance, {.exposure = 1.0f}, "exposure 1"),
        shown(radiance, {.exposure = 6.0f}, "exposure 6"),
        shown(radiance, {.exposure = 2.0f, .tone_map = ToneMap::reinhard}, "Reinhard"),
        shown(radiance, {.exposure = 2.0f, .tone_map = ToneMap::reinhard_extended, .white = kWhite}, "extended"),
        plot_panel(options, "curves", "", curves(), size)};
    save_panels(options, "tone_mapping", 3, panels);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "70_hdr_tone_mapping", draw);
}
