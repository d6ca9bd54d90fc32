// 45_other_models: brushed metal (Ward), threads (Heidrich and Seidel), and other distributions of microfacets.
// Page docs/45_other_models.md | After 42_cook_torrance | New: ward_anisotropic(), heidrich_seidel(), grain
// Break at: ward_exponent | Look at: slope_t, slope_b | Try: kAcross 0.1, kGrain {1, 0, 0}, kAlpha 0.15
#include <cmath>
#include <string>

#include "examples/example.hpp"
#include "examples/lit_scene.hpp"

using namespace kreda;
using namespace kreda::examples;
using lighting::Distribution;
using lighting::ReflectionModel;

namespace {

constexpr float kAlong = 0.08f, kAcross = 0.5f;
constexpr float kAlpha = 0.25f;
const glm::vec3 kGrain(0.0f, 1.0f, 0.0f);

/// A ball under two lamps, with this material.
scene::Scene ball(glm::ivec2 size, const lighting::Material& material) {
    scene::Scene scene = empty_scene(size);
    scene.camera.position = {0.0f, 1.6f, 7.0f};
    scene.camera.vertical_fov_deg = 21.5f;
    scene.camera.target = {0.0f, -0.16f, 0.0f};
    add_shape(scene, "sphere", 128, glm::vec3(0.0f), material);
    scene.lights = {directional_light({0.7f, -0.9f, -0.9f}, 1.0f), directional_light({-1.0f, -0.15f, -0.3f}, 0.45f)};
    return scene;
}

lighting::Material local_model(ReflectionModel model, const glm::vec3& grain) {
    lighting::Material material = shiny(srgb(0x57667a), 48.0f, model);
    material.phong.specular = glm::vec3(0.5f, 0.52f, 0.55f);
    material.phong.grain = grain;
    return material;
}

/// Ward's model: widths of the highlight along the grain and across it.
lighting::Material ward(const glm::vec2& alpha, const glm::vec3& grain = kGrain) {
    lighting::Material material = local_model(ReflectionModel::ward, grain);
    material.phong.specular = glm::vec3(0.16f, 0.17f, 0.18f);
    material.phong.ward_alpha = alpha;
    return material;
}

/// Cook and Torrance's model with another D, everything else the same.
lighting::Material facets(Distribution distribution) {
    lighting::Material material = microfacet(srgb(0x8f4a3c), 0.0f, std::sqrt(kAlpha));
    material.cook_torrance.distribution = distribution;
    material.cook_torrance.ior = glm::vec3(2.2f);  // a glaze that reflects 14 % head on
    return material;
}

void draw(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 4, 2);
    const std::vector<std::pair<std::string, lighting::Material>> models = {
        {"Ward", ward({kAlpha, kAlpha})},
        {"grain |", ward({kAlong, kAcross})},
        {"grain -", ward({kAlong, kAcross}, {1.0f, 0.0f, 0.0f})},
        {"threads |", local_model(ReflectionModel::heidrich_seidel, kGrain)},
        {"GGX", facets(Distribution::ggx)},
        {"Beckmann", facets(Distribution::beckmann)},
        {"Gaussian", facets(Distribution::gaussian)},
        {"Blinn-Phong", facets(Distribution::blinn_phong)}};
    std::vector<Panel> panels;
    for (const auto& [name, material] : models) {
        scene::Scene scene = ball(size, material);
        const bool physical = material.model == ReflectionModel::cook_torrance;
        for (lighting::Light& light : scene.lights) light.intensity *= physical ? raster::kPi : 1.0f;
        panels.push_back(captioned(scene, name));
    }
    save_panels(options, "models", 4, panels);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "45_other_models", draw);
}
