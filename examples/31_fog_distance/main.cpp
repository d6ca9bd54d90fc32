// 31_fog_distance: distance along the view direction or from the eye; turn the camera and planar fog changes.
// Page docs/31_fog_distance.md | After 30_fog | New: planar_distance(), radial_distance()
// Break at: planar_distance | Look at: z, p | Try: vertical_fov_deg 90
#include <cmath>

#include <glm/trigonometric.hpp>

#include "examples/example.hpp"
#include "examples/lit_scene.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

const glm::vec3 kMist = srgb(0x9fb2bd);

/// Balls in a ring around the eye, all 5 away along the ground: radial fog must treat them alike.
scene::Scene make_scene(glm::ivec2 size, lighting::FogDistance distance, double turn_deg) {
    scene::Scene scene = empty_scene(size);
    scene.image.background = kMist;
    scene.camera.position = {0.0f, 0.6f, 0.0f};
    const double turn = glm::radians(turn_deg);
    scene.camera.target = scene.camera.position + glm::vec3(std::sin(turn), -0.06, -std::cos(turn));
    scene.camera.vertical_fov_deg = 60.0f;
    scene.fog.mode = lighting::FogMode::exp2;
    scene.fog.density = 0.2f;
    scene.fog.color = kMist;
    scene.fog.distance = distance;
    const int ground = add_shape(scene, "plane", 1, {0.0f, -0.6f, 0.0f}, matte(srgb(0x4d5b48)));
    scene.objects[ground].world_from_object[0][0] = scene.objects[ground].world_from_object[2][2] = 60.0f;
    for (int angle_deg = -90; angle_deg <= 90; angle_deg += 15) {
        const double angle = glm::radians(static_cast<double>(angle_deg));
        const glm::vec3 place(5.0 * std::sin(angle), 0.0, -5.0 * std::cos(angle));
        const int ball = add_shape(scene, "sphere", 32, place, matte(angle_deg == 0 ? kRed : kOrange));
        for (int axis = 0; axis < 3; ++axis) scene.objects[ball].world_from_object[axis] *= 0.5f;
    }
    scene.lights = {directional_light({0.2f, -1.0f, -0.3f})};
    return scene;
}

void draw(const Options& options) {
    using lighting::FogDistance;
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 2);
    std::vector<Panel> panels;
    for (const FogDistance distance : {FogDistance::planar, FogDistance::radial}) {
        const std::string name = distance == FogDistance::planar ? "planar" : "radial";
        panels.push_back(captioned(make_scene(size, distance, 0.0), name));
        panels.push_back(captioned(make_scene(size, distance, 40.0), name + ", turned"));
    }
    save_panels(options, "distance", 2, panels);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "31_fog_distance", draw);
}
