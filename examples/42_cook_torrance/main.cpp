// 42_cook_torrance: balls from smooth to rough and from plastic to metal; and the light that a single bounce loses.
// Page docs/42_cook_torrance.md | After 41_microfacets | New: cook_torrance(), prepare(), combine_terms(), Kulla-Conty
// Break at: cook_torrance | Look at: n, l, v, m, D, V, F | Try: kPaint, kFurnaceLights 50, Distribution::beckmann

#include "examples/example.hpp"
#include "examples/lit_scene.hpp"

using namespace kreda;
using namespace kreda::examples;
using lighting::EnergyCompensation;
using lighting::Geometry;

namespace {

constexpr float kRoughness[] = {0.2f, 0.35f, 0.5f, 0.75f, 1.0f};
constexpr float kMetallic[] = {0.0f, 0.5f, 1.0f};
constexpr float kFurnaceRoughness[] = {0.5f, 0.6f, 0.7f, 0.85f, 1.0f};
constexpr int kFurnaceLights = 400;
const glm::vec3 kPaint = srgb(0xe07a5a);

/// A place for a ball in a grid of `columns` x `rows`, two units and a bit apart, the first in the upper left.
glm::vec3 place_in_grid(int column, int row, int columns, int rows) {
    constexpr float kStep = 2.2f;
    return {kStep * (float(column) - 0.5f * float(columns - 1)), kStep * (0.5f * float(rows - 1) - float(row)), 0.0f};
}

scene::Scene grid_scene(glm::ivec2 size, float height) {
    scene::Scene scene = empty_scene(size);
    scene.ambient = glm::vec3(0.0f);
    scene.camera.position = {0.0f, 0.0f, 40.0f};
    scene.camera.projection = raster::Projection::orthographic;
    scene.camera.height = height;
    return scene;
}

/// Five roughnesses by three degrees of metal.
scene::Scene balls(glm::ivec2 size) {
    scene::Scene scene = grid_scene(size, 7.0f);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 5; ++column) {
            add_shape(scene, "sphere", 96, place_in_grid(column, row, 5, 3),
                      microfacet(kPaint, kMetallic[row], kRoughness[column]));
        }
    }
    scene.lights = {directional_light({1.0f, -1.0f, -0.9f}, 3.0f), directional_light({-1.0f, -0.2f, -0.35f}, 1.6f),
                    directional_light({0.1f, 1.0f, -0.25f}, 0.6f)};
    return scene;
}

/// A white metal, F = 1, in light of radiance 1/2 from all sides before a background of 1/2. What reflects everything
/// cannot be seen: that is the white furnace.
scene::Scene furnace(glm::ivec2 size, Geometry geometry, EnergyCompensation compensation) {
    scene::Scene scene = grid_scene(size, 2.4f);
    scene.image.background = glm::vec3(0.5f);
    for (int column = 0; column < 5; ++column) {
        lighting::Material white = microfacet(glm::vec3(1.0f), 1.0f, kFurnaceRoughness[column]);
        white.cook_torrance.geometry = geometry;
        white.cook_torrance.energy_compensation = compensation;
        add_shape(scene, "sphere", 96, place_in_grid(column, 0, 5, 1), white);
    }
    scene.lights = lights_all_around(kFurnaceLights, [](const glm::vec3&) { return glm::vec3(0.5f); });
    return scene;
}

void draw(const Options& options) {
    render_and_save(options, "balls", balls({options.width, options.height}));

    const glm::ivec2 row = panel_size(options.width, options.height, 1, 3);
    const auto furnace_row = [&](Geometry geometry, EnergyCompensation compensation, const char* caption) {
        return Panel(render_outlined(options, furnace(row, geometry, compensation)), caption);
    };
    const std::vector<Panel> rows = {
        furnace_row(Geometry::schlick_ggx, EnergyCompensation::none, "Schlick-GGX"),
        furnace_row(Geometry::smith_correlated, EnergyCompensation::none, "Smith"),
        furnace_row(Geometry::smith_correlated, EnergyCompensation::kulla_conty, "+ Kulla-Conty")};
    save_panels(options, "furnace", 1, rows);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "42_cook_torrance", draw);
}
