// 20_lights: the sun, a lamp, a spotlight; and how a lamp weakens with distance.
// Page docs/20_lights.md | After 15_mesh | New: Light, sample(), attenuate(), spot_cone()
// Break at: sample_spot | Look at: sample.l, cos_angle | Try: attenuation {1, 0, 0}, outer_cone_deg 60
#include "examples/example.hpp"
#include "examples/lit_scene.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

/// A row of balls on a table, seen from above; the lamps hang over the left ball.
scene::Scene make_scene(glm::ivec2 size, const lighting::Light& light) {
    scene::Scene scene = empty_scene(size);
    scene.camera.position = {0.0f, 4.2f, 6.2f};
    scene.camera.target = {0.0f, 0.1f, 0.0f};
    scene.camera.vertical_fov_deg = 32.0f;
    const int table = add_shape(scene, "plane", 1, {0.0f, -0.5f, 0.0f}, matte(kDust));
    scene.objects[table].world_from_object[0][0] = scene.objects[table].world_from_object[2][2] = 8.0f;
    for (int i = -1; i <= 1; ++i) {
        const int ball = add_shape(scene, "sphere", 64, {1.6f * i, 0.0f, 0.0f}, shiny(kOrange, 40.0f));
        for (int axis = 0; axis < 3; ++axis) scene.objects[ball].world_from_object[axis] *= 0.5f;
    }
    scene.lights = {light};
    return scene;
}

void draw(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 2);
    const lighting::Light sun = directional_light({0.6f, -1.0f, -0.4f});
    const lighting::Light lamp = point_light({-1.6f, 1.5f, 0.6f});
    lighting::Light fading_lamp = lamp;
    fading_lamp.attenuation = {0.0f, 0.0f, 1.0f};  // 1 / d^2
    fading_lamp.intensity = 2.0f;
    lighting::Light spot = lamp;
    spot.type = lighting::LightType::spot;
    spot.direction = {0.5f, -1.5f, -0.6f};
    spot.inner_cone_deg = 18.0f;
    spot.outer_cone_deg = 32.0f;
    const std::vector<Panel> panels = {
        captioned(make_scene(size, sun), "directional"), captioned(make_scene(size, lamp), "point"),
        captioned(make_scene(size, fading_lamp), "point, $1/d^2$"), captioned(make_scene(size, spot), "spot")};
    save_panels(options, "lights", 2, panels);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "20_lights", draw);
}
