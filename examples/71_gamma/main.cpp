// 71_gamma: half the light, written as it is and written for a display; why sums of light must be linear.
// Page docs/71_gamma.md | After 70_hdr_tone_mapping | New: srgb_from_linear(), Transfer, 8-bit codes
// Break at: srgb_from_linear | Look at: toe, shoulder | Try: Transfer::gamma with 1.8, kSteps 32
#include <cmath>
#include <cstdio>
#include <string>

#include "examples/example.hpp"
#include "examples/lit_scene.hpp"
#include "scene/render/render.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

constexpr int kSteps = 12;

/// What a display makes of the number x in the file: the light of display(x). It decodes sRGB.
float display(float x) {
    return raster::linear_from_srgb(x);
}

/// One pixel white, one black, row by row shifted: from afar exactly half the light, whatever the display's curve is.
Image checkerboard(glm::ivec2 size) {
    Image image = make_board(size.x, size.y);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) image.set_rgb(x, y, glm::vec3((x + y) % 2 == 0 ? 1.0f : 0.0f));
    }
    return image;
}

/// The checkerboard with two windows: 0.5 written without encoding, and encoded. Squint: which window vanishes?
Panel half_the_light(glm::ivec2 size, int picture_height) {
    Panel panel(checkerboard(size));
    const int scale = text_scale(picture_height);
    const int width = size.x * 3 / 10, height = size.y / 2, top = size.y / 6;
    const auto window = [&](int left, float light, const char* label) {
        fill_rectangle(panel.image, left, top, width, height, glm::vec3(light));
        fill_rectangle(panel.image, left, size.y * 13 / 16 - 3 * scale, width, 13 * scale, kBoard);
        const glm::vec2 start(left + scale, size.y * 13 / 16 + 7 * scale);
        panel.labels.push_back({start, label, kChalk, caption_size(picture_height)});
    };
    window(size.x / 8, display(0.5f), "as it is");
    window(size.x * 23 / 40, display(raster::srgb_from_linear(0.5f)), "encoded");
    return panel;
}

/// Equal steps of light from 0 to 1: above written as they are, below encoded.
Panel steps(glm::ivec2 size, int picture_height) {
    Panel panel(make_board(size.x, size.y));
    for (int i = 0; i < kSteps; ++i) {
        const float light = static_cast<float>(i) / (kSteps - 1);
        const int left = i * size.x / kSteps, right = (i + 1) * size.x / kSteps;
        fill_rectangle(panel.image, left, 0, right - left, size.y / 2, glm::vec3(display(light)));
        fill_rectangle(panel.image, left, size.y / 2, right - left, size.y / 2, glm::vec3(light));
    }
    const float type = caption_size(picture_height), right = static_cast<float>(size.x) - 0.4f * type;
    for (const bool encoded : {false, true}) {
        const char* const text = encoded ? "encoded" : "as it is";
        const float top = encoded ? static_cast<float>(size.y / 2) : 0.0f;
        panel.labels.push_back({{right - tools::type_width(text, type), top + 1.3f * type}, text, kBoard, type});
    }
    return panel;
}

/// A ball that is lit from the left: a half moon.
scene::Scene half_moon(glm::ivec2 size) {
    scene::Scene scene = empty_scene(size);
    scene.image.background = glm::vec3(0.0f);
    scene.camera.position = {0.0f, 0.0f, 5.0f};
    scene.camera.vertical_fov_deg = 27.0f;
    scene.ambient = glm::vec3(0.0f);
    add_shape(scene, "sphere", 128, glm::vec3(0.0f), matte(glm::vec3(0.8f)));
    scene.lights = {directional_light({1.0f, -0.15f, -0.3f}, 1.2f)};
    return scene;
}

/// The same radiance, written as it is: a display shows it too dark, and the edge of the night too soft.
Image unencoded(Image radiance) {
    for (float& value : radiance.values) value = display(raster::saturate(value));
    return radiance;
}

void print_numbers() {
    const auto code = [](float x) { return static_cast<int>(std::lround(255.0f * x)); };
    const float half = 0.5f;
    std::printf("light 0.5 written as it is:  code %d, shows as %.4f (sRGB), %.4f (power 2.2)\n", code(half),
                display(half), raster::pow(half, 2.2f));
    std::printf("light 0.5 encoded:           code %d, shows as %.4f (sRGB); by the power 1/2.2: code %d\n",
                code(raster::srgb_from_linear(half)), display(raster::srgb_from_linear(half)),
                code(raster::pow(half, 1.0f / 2.2f)));
    std::printf("codes between light 0 and 0.1: %d as it is, %d encoded\n", code(0.1f),
                code(raster::srgb_from_linear(0.1f)));
}

void draw(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 2);
    const Image radiance = scene::render(half_moon(size));
    const Image as_it_is = unencoded(radiance);
    save_panels(options, "gamma", 2,
                {half_the_light(size, options.height),
                 steps(size, options.height),
                 {as_it_is, "as it is"},
                 {radiance, "encoded"}});
    print_numbers();
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "71_gamma", draw);
}
