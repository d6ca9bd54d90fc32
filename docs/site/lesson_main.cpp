// NN_name: WHAT IT SHOWS, IN A SENTENCE.
// Page docs/NN_name.md | After 21_lambert | New: FUNCTION()
// Break at: lambert | Look at: n, l, m.diffuse | Try: A CHANGE OF A NUMBER
#include "examples/example.hpp"
#include "examples/lit_scene.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

scene::Scene make_ball(glm::ivec2 size) {
    scene::Scene scene = empty_scene(size);
    scene.camera.position = {0.0f, 0.0f, 4.0f};
    scene.camera.vertical_fov_deg = 36.0f;
    add_shape(scene, "sphere", 96, glm::vec3(0.0f), matte(kBlue));
    scene.lights = {directional_light({-1.0f, -1.0f, -1.0f})};
    return scene;
}

void draw(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 1, 1);
    std::vector<Panel> panels;
    panels.push_back(captioned(make_ball(size), "CAPTION"));
    save_panels(options, "picture", 1, panels);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "NN_name", draw);
}
