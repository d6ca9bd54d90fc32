// 32_fog_per_vertex: fog computed at the vertices and interpolated, on a coarse and on a fine ground.
// Page docs/32_fog_per_vertex.md | After 30_fog | New: FogFrequency
// Break at: fog_vertices | Look at: streams.fog | Try: detail 4, 16, 64; mode linear
#include "examples/example.hpp"
#include "examples/lit_scene.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

const glm::vec3 kMist = srgb(0x9fb2bd);

/// A ground of `detail` x `detail` quads, 24 units wide; the eye stands above its middle.
scene::Scene make_scene(glm::ivec2 size, int detail, lighting::FogFrequency frequency) {
    scene::Scene scene = empty_scene(size);
    scene.image.background = kMist;
    scene.camera.position = {0.0f, 1.6f, 0.0f};
    scene.camera.target = {0.0f, 0.6f, -4.0f};
    scene.camera.vertical_fov_deg = 50.0f;
    scene.fog.mode = lighting::FogMode::exp;
    scene.fog.density = 0.12f;
    scene.fog.color = kMist;
    scene.fog.frequency = frequency;
    const int ground = add_shape(scene, "plane", detail, glm::vec3(0.0f), matte(srgb(0x2f7a3a)));
    scene.objects[ground].world_from_object[0][0] = scene.objects[ground].world_from_object[2][2] = 12.0f;
    scene.lights = {directional_light({0.0f, -1.0f, 0.0f})};
    return scene;
}

void draw(const Options& options) {
    using lighting::FogFrequency;
    const glm::ivec2 size = panel_size(options.width, options.height, 3, 1);
    const std::vector<Panel> panels = {captioned(make_scene(size, 2, FogFrequency::vertex), "vertex, 2 × 2"),
                                       captioned(make_scene(size, 24, FogFrequency::vertex), "vertex, 24 × 24"),
                                       captioned(make_scene(size, 2, FogFrequency::pixel), "pixel, 2 × 2")};
    save_panels(options, "frequency", 3, panels);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "32_fog_per_vertex", draw);
}
