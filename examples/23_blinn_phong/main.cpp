// 23_blinn_phong: the half vector for the mirror vector: the same exponent, the matched one, the difference.
// Page docs/23_blinn_phong.md | After 22_phong_terms | New: blinn_phong(), half_vector()
// Break at: blinn_phong | Look at: n, l, v, then h, sigma | Try: shininess 5, a light from the side
#include "examples/example.hpp"
#include "examples/lit_scene.hpp"
#include "lighting/reflection.hpp"
#include "scene/render/render.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

constexpr float kShininess = 24.0f;
constexpr float kGain = 4.0f;  ///< the differences are shown this many times as bright

scene::Scene make_scene(glm::ivec2 size, lighting::ReflectionModel model, float shininess) {
    scene::Scene scene = empty_scene(size);
    scene.camera.position = {0.0f, 0.0f, 4.0f};
    scene.camera.vertical_fov_deg = 36.0f;
    add_shape(scene, "sphere", 96, glm::vec3(0.0f), shiny(0.5f * kBlue, shininess, model));
    scene.lights = {directional_light({1.0f, -0.8f, -1.6f}), directional_light({-1.0f, 0.1f, 0.25f})};
    return scene;
}

void draw(const Options& options) {
    using lighting::ReflectionModel;
    const glm::ivec2 size = panel_size(options.width, options.height, 3, 2);
    const float matched = lighting::blinn_exponent_matching_phong(kShininess);
    const scene::Scene phong = make_scene(size, ReflectionModel::phong, kShininess);
    const scene::Scene same = make_scene(size, ReflectionModel::blinn_phong, kShininess);
    const scene::Scene wider = make_scene(size, ReflectionModel::blinn_phong, matched);
    std::vector<Panel> panels = {captioned(phong, "Phong, $h$ = 24"), captioned(same, "Blinn, $h$ = 24"),
                                 captioned(wider, "Blinn, $h$ = 96"), empty_panel(size)};
    for (const scene::Scene& blinn : {same, wider}) {
        panels.emplace_back(difference_picture(render(phong), render(blinn), kGain), "difference × 4");
    }
    save_panels(options, "blinn_phong", 3, panels);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "23_blinn_phong", draw);
}
