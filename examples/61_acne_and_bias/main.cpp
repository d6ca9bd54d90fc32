// 61_acne_and_bias: a surface shadows itself, a bias mends it, too much of it lifts the shadow off its object.
// Page docs/61_acne_and_bias.md | After 60_depth_from_the_light | New: least_bias(), least_normal_offset()
// Break at: map_point_parallel | Look at: slope, point.distance | Try: slope_bias 0.5, a map of 2048 texels
#include "examples/example.hpp"
#include "examples/table_scene.hpp"

using namespace kreda;
using namespace kreda::examples;
using shadows::ShadowBias;

namespace {

scene::Scene make_scene(glm::ivec2 size, int samples, ShadowBias bias, float constant_bias) {
    scene::Scene scene = sunny_table_closely(size, samples);
    scene.shadow.size = 256;
    scene.shadow.bias = bias;
    scene.shadow.constant_bias = constant_bias;
    return scene;
}

void draw(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 2);
    const auto panel = [&](ShadowBias bias, float constant_bias, const char* caption) {
        return captioned(make_scene(size, options.samples, bias, constant_bias), caption);
    };
    save_panels(
        options, "bias", 2,
        {panel(ShadowBias::none, 0.0f, "none: acne"), panel(ShadowBias::constant, 0.3f, "too much: peter-panning"),
         panel(ShadowBias::slope, 0.0005f, "as much as the slope asks"),
         panel(ShadowBias::normal_offset, 0.0005f, "along the normal")});
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "61_acne_and_bias", draw);
}
