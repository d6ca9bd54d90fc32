// A mirrored object (a negative scale) looks like its mirror image, not like its inside.
#include <doctest/doctest.h>

#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"

using namespace kreda;

namespace {

raster::Image render_text(const std::string& shading, const std::string& scale, const std::string& light) {
    const std::string text = "[image]\nsize = [60, 60]\n[camera]\nposition = [0, 0, 4]\n[shading]\n" + shading +
                             "[[light]]\ndirection = " + light + "\n[[object]]\nmesh = \"torus_knot\"\ndetail = 48\n" +
                             scale;
    return scene::render(scene::read_scene_text(text, "test", ""));
}

}  // namespace

TEST_CASE("Mirroring an object and the light about x mirrors the picture") {
    for (const char* frequency : {"frequency = 'flat'\n", "frequency = 'gouraud'\n", "frequency = 'phong'\n"}) {
        CAPTURE(frequency);
        const raster::Image plain = render_text(frequency, "", "[-1, -1, -2]");
        const raster::Image mirrored = render_text(frequency, "scale = [-1, 1, 1]\n", "[1, -1, -2]");
        int different = 0;
        for (int y = 0; y < 60; ++y) {
            for (int x = 0; x < 60; ++x) {
                different += glm::distance(plain.rgb(x, y), mirrored.rgb(59 - x, y)) > 1e-4f ? 1 : 0;
            }
        }
        // The snap to 1/256 sample rounds halves up on both sides of the middle, so a few silhouette samples may
        // differ.
        CHECK(different < 20);
    }
}
