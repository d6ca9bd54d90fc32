// 30_fog: linear, exponential and squared exponential fog on a row of balls, and the three curves.
// Page docs/30_fog.md | After 22_phong_terms | New: Fog, fog_linear(), fog_exp(), fog_exp2(), mix_fog()
// Break at: fog_exp | Look at: z_p, optical_depth | Try: density 0.3, start 8
#include <cstdio>

#include "examples/lit_scene.hpp"
#include "examples/plots.hpp"
#include "lighting/fog.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

constexpr float kStart = 2.0f, kEnd = 12.0f, kDensity = 0.15f;
const glm::vec3 kMist = srgb(0x9fb2bd);

lighting::Fog make_fog(lighting::FogMode mode) {
    lighting::Fog fog;
    fog.mode = mode;
    fog.color = kMist;
    fog.start = kStart;
    fog.end = kEnd;
    fog.density = kDensity;
    return fog;
}

scene::Scene make_scene(glm::ivec2 size, lighting::FogMode mode) {
    scene::Scene scene = empty_scene(size);
    scene.image.background = kMist;
    scene.camera.position = {-1.6f, 1.3f, 2.2f};
    scene.camera.target = {0.8f, 0.2f, -4.0f};
    scene.camera.vertical_fov_deg = 40.0f;
    scene.fog = make_fog(mode);
    const int ground = add_shape(scene, "plane", 1, {0.0f, -0.6f, 0.0f}, matte(srgb(0x4d5b48)));
    scene.objects[ground].world_from_object[0][0] = scene.objects[ground].world_from_object[2][2] = 60.0f;
    for (int i = 0; i < 8; ++i) {
        const int ball =
            add_shape(scene, "sphere", 48, {0.0f, 0.0f, -1.6f * static_cast<float>(i)}, shiny(kRed, 40.0f));
        for (int axis = 0; axis < 3; ++axis) scene.objects[ball].world_from_object[axis] *= 0.6f;
    }
    scene.lights = {directional_light({0.5f, -1.0f, -0.6f})};
    return scene;
}

/// f over the distance 0 .. 14.
Plot curves() {
    constexpr AxisRange kDistance{0.0, 14.0};
    const auto linear = [](double z) { return lighting::fog_linear(static_cast<float>(z), kStart, kEnd); };
    const auto exp = [](double z) { return lighting::fog_exp(static_cast<float>(z), kDensity); };
    const auto exp2 = [](double z) { return lighting::fog_exp2(static_cast<float>(z), kDensity); };
    Plot plot = empty_plot("distance $z$", "$f$");
    plot.series = {curve("linear", kDistance, linear), curve("exp", kDistance, exp), curve("exp2", kDistance, exp2)};
    plot.x_range = kDistance;
    plot.y_range = {0.0, 1.0};
    plot.key = "outside top center horizontal samplen 2 width -2";
    return plot;
}

/// Things at the far plane are there or not at once; in fog that ends at it they come slowly.
std::vector<Panel> far_planes(glm::ivec2 size) {
    std::vector<Panel> panels;
    for (const lighting::FogMode mode : {lighting::FogMode::none, lighting::FogMode::linear}) {
        const std::string fog = mode == lighting::FogMode::none ? "no fog" : "fog";
        for (const float far : {12.5f, 11.0f}) {
            scene::Scene scene = make_scene(size, mode);
            scene.camera.far = far;
            scene.fog.end = 11.0f;
            char caption[64];
            std::snprintf(caption, sizeof caption, "%s, far plane at %g", fog.c_str(), static_cast<double>(far));
            panels.push_back(captioned(scene, caption));
        }
    }
    return panels;
}

void draw(const Options& options) {
    using lighting::FogMode;
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 2);
    const std::vector<Panel> panels = {
        captioned(make_scene(size, FogMode::linear), "linear"), captioned(make_scene(size, FogMode::exp), "exp"),
        captioned(make_scene(size, FogMode::exp2), "exp2"), plot_panel(options, "curves", "", curves(), size)};
    save_panels(options, "fog", 2, panels);
    save_panels(options, "far_plane", 2, far_planes(size));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "30_fog", draw);
}
