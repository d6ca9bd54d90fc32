// 21_lambert: a matt surface is as bright as the cosine of the angle to the light.
// Page docs/21_lambert.md | After 20_lights | New: lambert(), positive_dot()
// Break at: lambert | Look at: n, l, m.diffuse | Try: an angle of 100 degrees, diffuse {1, 1, 1}
#include <cmath>

#include <glm/trigonometric.hpp>

#include "examples/example.hpp"
#include "examples/lit_scene.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

constexpr float kDiffuse = 0.8f;  ///< m_D of the wall, the same in all channels

lighting::Material wall_material() {
    lighting::Material wall = matte(glm::vec3(kDiffuse));
    wall.phong.ambient = glm::vec3(0.0f);
    return wall;
}

/// A wall that fills the view, n toward the viewer; the light comes from phi degrees to its side.
scene::Scene make_wall(glm::ivec2 size, double phi_deg) {
    scene::Scene scene = empty_scene(size);
    scene.camera.position = {0.0f, 4.0f, 0.0f};
    scene.camera.up = {0.0f, 0.0f, -1.0f};
    scene.camera.projection = raster::Projection::orthographic;
    scene.camera.height = 1.0f;
    add_shape(scene, "plane", 1, glm::vec3(0.0f), wall_material());
    const double phi = glm::radians(phi_deg);
    scene.lights = {directional_light(glm::vec3(std::sin(phi), -std::cos(phi), 0.0))};
    return scene;
}

scene::Scene make_ball(glm::ivec2 size) {
    scene::Scene scene = empty_scene(size);
    scene.camera.position = {0.0f, 0.0f, 4.0f};
    scene.camera.vertical_fov_deg = 36.0f;
    add_shape(scene, "sphere", 96, glm::vec3(0.0f), matte(kBlue));
    scene.lights = {directional_light({-1.0f, -1.0f, -1.0f})};
    return scene;
}

void draw(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 3, 2);
    std::vector<Panel> panels;
    for (const int phi : {0, 30, 60, 80, 100}) {
        panels.push_back(captioned(make_wall(size, phi), std::to_string(phi) + "°"));
    }
    panels.push_back(captioned(make_ball(size), "all angles"));
    save_panels(options, "cosine", 3, panels);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "21_lambert", draw);
}
