// 25_exponents: the exponent h says how narrow the highlight is, from chalk to a billiard ball.
// Page docs/25_exponents.md | After 22_phong_terms | New: PhongMaterial::shininess
// Break at: phong | Look at: sigma, highlight, m.shininess | Try: shininess 0 and 100000
#include "examples/example.hpp"
#include "examples/lit_scene.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

/// Only the highlight, in white: Sigma^h and nothing else. The light shines from behind the camera.
scene::Scene make_scene(glm::ivec2 size, float shininess) {
    scene::Scene scene = empty_scene(size);
    scene.camera.position = {0.0f, 0.0f, 40.0f};
    scene.camera.projection = raster::Projection::orthographic;
    scene.camera.height = 2.4f;
    lighting::Material material = shiny(glm::vec3(0.0f), shininess);
    material.phong.specular = glm::vec3(1.0f);
    add_shape(scene, "sphere", 128, glm::vec3(0.0f), material);
    scene.lights = {directional_light({0.0f, 0.0f, -1.0f})};
    return scene;
}

void draw(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 3, 2);
    std::vector<Panel> panels;
    for (const int h : {1, 4, 16, 64, 256, 1024}) {
        panels.push_back(captioned(make_scene(size, static_cast<float>(h)), "$h$ = " + std::to_string(h)));
    }
    save_panels(options, "exponents", 3, panels);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "25_exponents", draw);
}
