// 62_pcf: texels show as stairs; compare first, then average, and they blur.
// Page docs/62_pcf.md | After 61_acne_and_bias | New: filter_box(), ShadowFilter::pcf
// Break at: filter_box | Look at: radius, side | Try: radius 12, size 32
#include "examples/example.hpp"
#include "examples/table_scene.hpp"

using namespace kreda;
using namespace kreda::examples;
using shadows::ShadowFilter;

namespace {

scene::Scene make_scene(glm::ivec2 size, int samples, int texels, ShadowFilter filter, int radius) {
    scene::Scene scene = sunny_table_closely(size, samples);
    scene.shadow.size = texels;
    scene.shadow.filter = filter;
    scene.shadow.radius = radius;
    return scene;
}

void draw(const Options& options) {
    const glm::ivec2 size = panel_size(options.width, options.height, 2, 2);
    const auto panel = [&](int texels, ShadowFilter filter, int radius, const char* caption) {
        return captioned(make_scene(size, options.samples, texels, filter, radius), caption);
    };
    save_panels(
        options, "pcf", 2,
        {panel(96, ShadowFilter::none, 0, "96 texels: aliasing"), panel(96, ShadowFilter::pcf, 1, "mean of 3 × 3"),
         panel(96, ShadowFilter::pcf, 3, "mean of 7 × 7"), panel(1024, ShadowFilter::pcf, 1, "1024 texels, 3 × 3")});
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, "62_pcf", draw);
}
