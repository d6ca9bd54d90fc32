// 22_phong_terms: ambient + diffuse + specular + emission, one picture each and their sum.
// Page docs/22_phong_terms.md | After 21_lambert | New: phong(), mirror_vector(), ReflectedTerms
// Break at: phong | Look at: n, l, v, m, then r, sigma, highlight | Try: shininess 4, 32, 256
#include "examples/example.hpp"
#include "examples/lit_scene.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

lighting::Material full_material() {
    lighting::Material material = shiny(kRed, 40.0f);
    material.phong.ambient = 0.25f * kRed;
    material.phong.emission = {0.0f, 0.02f, 0.08f};
    return material;
}

/// The material with every constant but one set to 0.
lighting::Material only(glm::vec3 lighting::PhongMaterial::*constant) {
    lighting::Material material = full_material();
    const glm::vec3 kept = material.phong.*constant;
    material.phong.ambient = material.phong.diffuse = material.phong.specular = material.phong.emission =
        glm::vec3(0.0f);
    material.phong.*constant = kept;
    return material;
}

scene::Scene make_scene(glm::ivec2 size, const lighting::Material& material) {
    scene::Scene scene = empty_scene(size);
    scene.image.background = glm::vec3(0.0f);
    scene.camera.position = {1.0f, 1.5f, 3.0f};
    scene.camera.target = {0.05f, 0.45f, 0.0f};
    scene.camera.vertical_fov_deg = 27.0f;
    scene.shading.cull = raster::CullMode::none;  // the pot is open at its rim
    add_shape(scene, "teapot", 12, glm::vec3(0.0f), material);
    scene.lights = {directional_light({0.8f, -1.2f, -1.0f}), directional_light({-1.0f, -0.3f, -0.3f}, 0.35f)};
    return scene;
}

void draw(const Options& options) {
    using M = lighting::PhongMaterial;
    const glm::ivec2 size = panel_size(options.width, options.height, 3, 2);
    const std::vector<Panel> panels = {captioned(make_scene(size, only(&M::ambient)), "ambient"),
                                       captioned(make_scene(size, only(&M::diffuse)), "diffuse"),
                                       captioned(make_scene(size, only(&M::specular)), "specular"),
                                       captioned(make_scene(size, only(&M::emission)), "emission"),
                                       captioned(make_scene(size, full_material()), "the sum")};
    save_panels(options, "terms", 3, panels);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "22_phong_terms", draw);
}
