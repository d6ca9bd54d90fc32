// 30_fog: linear, exponential and squared exponential fog on a row of balls, and the three curves.
// Page docs/30_fog.md | After 22_phong_terms | New: Fog, fog_linear(), fog_exp(), fog_exp2(), mix_fog()
// Break at: fog_exp | Look at: z_p, optical_depth | Try: density 0.3, start 8
#include "examples/example.hpp"
#include "examples/lit_scene.hpp"

using namespace kreda;
using namespace kreda::examples;

namespace {

constexpr float kStart = 2.0f, kEnd = 12.0f, kDensity = 0.15f;
const glm::vec3 kMist = srgb(0x9fb2bd);

lighting::Fog make_fog(lighting::FogMode mode) {
    lighting::Fog fog;
    fog.mode = mode;
    fog.color = kMist;
    fog.start = kStart;
    fog.end = kEnd;
    fog.density = kDensity;
    return fog;
}

scene::Scene make_scene(glm::ivec2 size, lighting::FogMode mode) {
    scene::Scene scene = empty_scene(size);
    scene.image.background = kMist;
    scene.camera.position = {-1.6f, 1.3f, 2.2f};
    scene.camera.target = {0.8f, 0.2f, -4.0f};
    scene.camera.vertical_fov_deg = 40.0f;
    scene.fog = make_fog(mode);
    const int ground = add_shape(scene, "plane", 1, {0.0f, -0.6f, 0.0f}, matte(srgb(0x4d5b48)));
    scene.objects[ground].world_from_object[0][0] = scene.objects[ground].world_from_object[2][2] = 60.0f;
    for (int i = 0; i < 8; ++i) {
        const int ball =
            add_shape(scene, "sphere", 48, {0.0f, 0.0f, -1.6f * static_cast<float>(i)}, shiny(kRed, 40.0f));
        for (int axis = 0; axis < 3; ++axis) scene.objects[ball].world_from_object[axis] *= 0.6f;
    }
    scene.lights = {directional_light({0.5f, -1.0f, -0.6f})};
    return scene;
}

/// f over the distance 0 .. 14.
Image draw_curves(glm::ivec2 size, int picture_height) {
    Image board = make_board(size.x, size.y);
    const auto place = [&](float z, float f) {
        return glm::vec2((0.06f + 0.9f * z / 14.0f) * float(size.x), (0.88f - 0.78f * f) * float(size.y));
    };
    draw_line(board, place(0.0f, 0.0f), place(14.0f, 0.0f), 1.5f, kDust);
    draw_line(board, place(0.0f, 0.0f), place(0.0f, 1.0f), 1.5f, kDust);
    const auto draw_curve = [&](const glm::vec3& color, auto f) {
        for (int i = 0; i < 140; ++i) {
            const float z = 0.1f * static_cast<float>(i), next = z + 0.1f;
            draw_line(board, place(z, f(z)), place(next, f(next)), 2.5f, color);
        }
    };
    draw_curve(kYellow, [](float z) { return lighting::fog_linear(z, kStart, kEnd); });
    draw_curve(kBlue, [](float z) { return lighting::fog_exp(z, kDensity); });
    draw_curve(kOrange, [](float z) { return lighting::fog_exp2(z, kDensity); });
    const int scale = text_scale(picture_height);
    const int x = size.x * 6 / 10;
    draw_text(board, x, size.y / 12, "f: linear", kYellow, scale);
    draw_text(board, x, size.y / 12 + 10 * scale, "   exp", kBlue, scale);
    draw_text(board, x, size.y / 12 + 20 * scale, "   exp2", kOrange, scale);
    return board;
}

void draw(const Options& options) {
    using lighting::FogMode;
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 2);
    const std::vector<Image> panels = {captioned(make_scene(size, FogMode::linear), "linear", options.height),
                                       captioned(make_scene(size, FogMode::exp), "exp", options.height),
                                       captioned(make_scene(size, FogMode::exp2), "exp2", options.height),
                                       draw_curves(size, options.height)};
    save(options, "fog", montage(options.width, options.height, 2, panels));
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "30_fog", draw);
}
