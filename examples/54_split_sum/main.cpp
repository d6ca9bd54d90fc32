// 54_split_sum: the split sum beside the integral it stands for; where they differ, by how much, and why.
// Page docs/54_split_sum.md | After 53_brdf_map | New: environment.reference, look_at_environment()
// Break at: look_at_environment | Look at: channels.prefiltered | Try: kSamples 16, 64, Sky::sunset, roughness 0.5
#include <algorithm>
#include <array>
#include <cstdio>

#include "examples/lit_scene.hpp"
#include "examples/plots.hpp"
#include "examples/view_panels.hpp"
#include "tools/measure/split_sum_error.hpp"

using namespace kreda;
using namespace kreda::examples;
using namespace kreda::tools;

namespace {

constexpr std::array<float, 5> kRoughness = {0.1f, 0.2f, 0.4f, 0.7f, 1.0f};
constexpr int kSamples = 512;                                  ///< a pixel of the integral
constexpr int kFloorSamples = 4096;                            ///< the sun is small: more
constexpr int kFewerFloorSamples = 1024, kFewerSamples = 256;  ///< where the pictures have more pixels
constexpr float kGain = 4.0f;

/// Roughness grows to the right; gold above, plastic below.
scene::Scene balls(glm::ivec2 size, int samples) {
    scene::Scene scene = empty_scene(size);
    scene.ambient = glm::vec3(0.0f);
    scene.image.samples = 1;
    scene.image.exposure = 0.7f;
    scene.camera.position = {0.0f, 0.0f, 40.0f};
    scene.camera.projection = raster::Projection::orthographic;
    scene.camera.height = 6.2f;
    scene.environment.on = true;
    scene.environment.sky = lighting::Sky::studio;
    scene.environment.samples = samples;
    for (int i = 0; i < 10; ++i) {
        const glm::vec3 place(2.2f * static_cast<float>(i % 5 - 2), i < 5 ? 1.3f : -1.0f, 0.0f);
        const glm::vec3 albedo = i < 5 ? glm::vec3(1.0f, 0.73f, 0.36f) : srgb(0xb03a2e);
        add_shape(scene, "sphere", 64, place, microfacet(albedo, i < 5 ? 1.0f : 0.0f, kRoughness[i % 5]));
    }
    return scene;
}

/// The errors of the golden balls over n.v, a curve for each roughness; as a table on stdout. Gold: F0 hides nothing.
Plot error_plot(const SpecularPicture& split, const SpecularPicture& exact) {
    constexpr float kStep = 0.1f;
    Plot plot = empty_plot("$n·v$", "error [%]");
    plot.x_range = {0.0, 1.0};
    plot.y_range = {0.0, 100.0};
    std::printf("roughness  error %%   by n.v: 0..0.1 to 0.9..1\n");
    for (std::size_t r = 0; r < kRoughness.size(); ++r) {
        std::printf("%9g %8.2f  ", kRoughness[r], error_percent(split, exact, kRoughness[r], 0.1f, 0.95f));
        char name[16];
        std::snprintf(name, sizeof name, "%g", kRoughness[r]);
        Series series{name, {}};
        for (int bin = 0; bin < 10; ++bin) {
            const float from = kStep * static_cast<float>(bin);
            const double error = error_percent(split, exact, kRoughness[r], from, from + kStep);
            std::printf(" %6.2f", error);
            series.points.push_back({from + 0.5f * kStep, error});
        }
        std::printf("\n");
        plot.series.push_back(series);
    }
    return plot;
}

void draw_balls(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 2);
    const int samples = options.draft ? kSamples : kFewerSamples;
    const scene::Scene scene = balls(size, samples);
    scene::RenderBuffers buffers;
    const SpecularPicture exact = draw_specular(with_reference(scene, samples), buffers);
    const SpecularPicture split = draw_specular(scene, buffers);
    const Image left = shown(scene, split.film), right = shown(scene, exact.film);
    const Image difference = difference_picture(left, right, kGain);
    save_panels(options, "balls", 2,
                {{left, "split sum"},
                 {right, "integral"},
                 {difference, "difference × 4"},
                 plot_panel(options, "error", "by roughness", error_plot(split, exact), size)});
}

/// The integral takes long: at most 960 x 540 pixels of it.
void draw_floor(Options options) {
    options.width = std::min(options.width, 960);
    options.height = std::min(options.height, 540);
    const int samples = options.draft ? kFloorSamples : kFewerFloorSamples;
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 1);
    scene::Scene scene = read_scene(options, KREDA_EXAMPLE_FOLDER "/floor.toml");
    scene.image.width = size.x;
    scene.image.height = size.y;
    const Image left = shown(scene, render(scene)), right = shown(scene, render(with_reference(scene, samples)));
    save_panels(options, "floor", 2, with_captions({left, right}, {"split sum", "integral"}));
}

void draw(const Options& options) {
    draw_balls(options);
    draw_floor(options);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "54_split_sum", draw);
}
