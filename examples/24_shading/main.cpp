// 24_shading: light once a triangle, once a vertex, or once a pixel; and where Gouraud misses the highlight.
// Page docs/24_shading.md | After 22_phong_terms | New: ShadingFrequency
// Break at: shade_points | Look at: points.count | Try: detail 96, shininess 200
#include "examples/example.hpp"
#include "examples/lit_scene.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

/// A coarse ball. The first light's highlight falls into the middle of a face, the second one's onto a vertex.
scene::Scene make_scene(glm::ivec2 size, scene::ShadingFrequency frequency, float shininess) {
    scene::Scene scene = empty_scene(size);
    scene.camera.position = {0.0f, 0.4f, 4.0f};
    scene.camera.vertical_fov_deg = 42.0f;
    scene.shading.frequency = frequency;
    add_shape(scene, "sphere", 16, glm::vec3(0.0f), shiny(kGreen, shininess));
    scene.lights = {directional_light({0.75f, -0.55f, -1.0f}), directional_light({-1.0f, -0.2f, -0.5f}, 0.3f)};
    return scene;
}

void draw(const Options& options) {
    using scene::ShadingFrequency;
    const glm::ivec2 size = panel_size(options.width, options.height, 3, 2);
    std::vector<Panel> panels;
    for (const float h : {10.0f, 80.0f}) {
        const std::string exponent = ", $h$ = " + std::to_string(static_cast<int>(h));
        panels.push_back(captioned(make_scene(size, ShadingFrequency::flat, h), "flat" + exponent));
        panels.push_back(captioned(make_scene(size, ShadingFrequency::gouraud, h), "Gouraud" + exponent));
        panels.push_back(captioned(make_scene(size, ShadingFrequency::phong, h), "Phong" + exponent));
    }
    save_panels(options, "shading", 3, panels);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "24_shading", draw);
}
