// 54_split_sum: the split sum beside the integral it stands for; where they differ, by how much, and why.
// Page docs/54_split_sum.md | After 53_brdf_map | New: environment.reference, look_at_environment()
// Break at: look_at_environment | Look at: channels.prefiltered | Try: kSamples 16, 64, Sky::sunset, roughness 0.5
#include <algorithm>
#include <array>
#include <cstdio>

#include "examples/chart.hpp"
#include "examples/example.hpp"
#include "examples/lit_scene.hpp"
#include "examples/view_panels.hpp"
#include "tools/measure/split_sum_error.hpp"

using namespace kreda;
using namespace kreda::examples;
using namespace kreda::tools;

namespace {

constexpr std::array<float, 5> kRoughness = {0.1f, 0.2f, 0.4f, 0.7f, 1.0f};
constexpr int kSamples = 512;        ///< a pixel of the integral
constexpr int kFloorSamples = 4096;  ///< the sun is small: more
constexpr float kGain = 4.0f;

/// Roughness grows to the right; gold above, plastic below.
scene::Scene balls(glm::ivec2 size) {
    scene::Scene scene = empty_scene(size);
    scene.ambient = glm::vec3(0.0f);
    scene.image.samples = 1;
    scene.image.exposure = 0.7f;
    scene.camera.position = {0.0f, 0.0f, 40.0f};
    scene.camera.projection = raster::Projection::orthographic;
    scene.camera.height = 6.2f;
    scene.environment.on = true;
    scene.environment.sky = lighting::Sky::studio;
    scene.environment.samples = kSamples;
    for (int i = 0; i < 10; ++i) {
        const glm::vec3 place(2.2f * static_cast<float>(i % 5 - 2), i < 5 ? 1.3f : -1.0f, 0.0f);
        const glm::vec3 albedo = i < 5 ? glm::vec3(1.0f, 0.73f, 0.36f) : srgb(0xb03a2e);
        add_shape(scene, "sphere", 64, place, microfacet(albedo, i < 5 ? 1.0f : 0.0f, kRoughness[i % 5]));
    }
    return scene;
}

/// The errors of the golden balls over n.v, a curve for each roughness; as a table on stdout. Gold: F0 hides nothing.
Image error_chart(glm::ivec2 size, int picture_height, const SpecularPicture& split, const SpecularPicture& exact) {
    constexpr float kStep = 0.1f;
    Chart chart = make_chart(size, picture_height, "error in % over n.v", {0.0, 1.0, 0.5}, {0.0, 100.0, 50.0});
    const glm::vec3 colors[] = {kChalk, kBlue, kGreen, kYellow, kRed};
    std::printf("roughness  error %%   by n.v: 0..0.1 to 0.9..1\n");
    for (std::size_t r = 0; r < kRoughness.size(); ++r) {
        std::printf("%9g %8.2f  ", kRoughness[r], error_percent(split, exact, kRoughness[r], 0.1f, 0.95f));
        glm::vec2 last(0.0f);
        for (int bin = 0; bin < 10; ++bin) {
            const float from = kStep * static_cast<float>(bin);
            const double error = error_percent(split, exact, kRoughness[r], from, from + kStep);
            std::printf(" %6.2f", error);
            const glm::vec2 point = chart.place(from + 0.5f * kStep, std::min(error, 100.0));
            if (bin > 0) draw_line(chart.image, last, point, 1.2f, colors[r]);
            last = point;
        }
        std::printf("\n");
        char name[16];
        std::snprintf(name, sizeof name, "%g", kRoughness[r]);
        legend(chart, name, colors[r], {0.75f, 0.04f});
    }
    return chart.image;
}

void draw_balls(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 2);
    const int scale = text_scale(options.height);
    const scene::Scene scene = balls(size);
    scene::RenderBuffers buffers;
    const SpecularPicture exact = draw_specular(with_reference(scene, kSamples), buffers);
    const SpecularPicture split = draw_specular(scene, buffers);
    Image left = shown(scene, split.film), right = shown(scene, exact.film);
    Image difference = difference_picture(left, right, kGain);
    draw_caption(left, "split sum", scale);
    draw_caption(right, "integral", scale);
    draw_caption(difference, "difference x 4", scale);
    save(options, "balls",
         montage(options.width, options.height, 2,
                 {left, right, difference, error_chart(size, options.height, split, exact)}));
}

void draw_floor(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 1);
    scene::Scene scene = read_scene(options, KREDA_EXAMPLE_FOLDER "/floor.toml");
    scene.image.width = size.x;
    scene.image.height = size.y;
    Image left = shown(scene, render(scene)), right = shown(scene, render(with_reference(scene, kFloorSamples)));
    draw_caption(left, "split sum", text_scale(options.height));
    draw_caption(right, "integral", text_scale(options.height));
    save(options, "floor", montage(options.width, options.height, 2, {left, right}));
}

void draw(const Options& options) {
    draw_balls(options);
    draw_floor(options);
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "54_split_sum", draw);
}
