// Laws about 60 to 63: shadow maps against rays, and a penumbra against similar triangles.
#include <algorithm>
#include <cmath>
#include <span>

#include <doctest/doctest.h>

#include "course.hpp"
#include "examples/table_scene.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/render/render.hpp"
#include "shadows/soft_filter.hpp"

using namespace kreda;
using namespace kreda::tests;
using shadows::ShadowBias;
using shadows::ShadowFilter;
using shadows::ShadowMethod;

namespace {

raster::AlignedVector<float> by_rays(scene::Scene scene) {
    scene.shadow.method = ShadowMethod::exact;
    return examples::shadow_factors(scene);
}

/// Share of the picture's samples that only one of the two calls dark.
double misclassified(std::span<const float> a, std::span<const float> b) {
    int wrong = 0;
    for (std::size_t i = 0; i < a.size(); ++i) wrong += (a[i] < 0.5f) != (b[i] < 0.5f);
    return wrong / static_cast<double>(a.size());
}

double mean(std::span<const float> values) {
    double sum = 0.0;
    for (const float value : values) sum += double{value};
    return sum / static_cast<double>(values.size());
}

}  // namespace

TEST_CASE("60_depth_from_the_light: the factor in the picture is that of rays but for one pixel in a hundred") {
    const raster::Image panel = linear_panel("60_depth_from_the_light/steps", 2, 2, 2);
    const auto exact = by_rays(examples::sunny_table({panel.width, panel.height}));
    int wrong = 0, looked_at = 0;
    for (int y = 0; y < panel.height - 14; ++y) {  // above the caption
        for (int x = 0; x < panel.width; ++x, ++looked_at) {
            wrong += (panel.at(0, x, y) < 0.5f) != (exact[static_cast<std::size_t>(y) * panel.width + x] < 0.5f);
        }
    }
    CHECK(wrong < looked_at / 100);
    CHECK(make_plan(examples::sunny_table({32, 18})).shadows.at(0).casters.size() ==
          documented_number("60_depth_from_the_light", "casters"));
}

TEST_CASE("60_depth_from_the_light: at 2048 texels and the default bias a hundredth is misclassified at most") {
    scene::Scene scene = examples::sunny_table({320, 180});
    scene.shadow.size = 2048;
    CHECK(misclassified(examples::shadow_factors(scene), by_rays(scene)) < 0.002);  // asked for: 0.01
    scene.lights = {examples::point_light(examples::kLampPosition)};
    scene.lights[0].shadow = true;
    CHECK(misclassified(examples::shadow_factors(scene), by_rays(scene)) < 0.01);
}

TEST_CASE("61_acne_and_bias: acne without bias - holes with too much - neither by slope or along the normal") {
    scene::Scene scene = examples::sunny_table({320, 180});
    scene.shadow.size = 256;
    const auto exact = by_rays(scene);
    const auto with = [&](ShadowBias bias, float constant) {
        scene.shadow.bias = bias;
        scene.shadow.constant_bias = constant;
        return examples::shadow_factors(scene);
    };
    CHECK(mean(with(ShadowBias::none, 0.0f)) < mean(exact) - 0.01);
    CHECK(mean(with(ShadowBias::constant, 0.3f)) > mean(exact) + 0.002);
    CHECK(misclassified(with(ShadowBias::slope, 0.0005f), exact) < 0.01);
    CHECK(misclassified(with(ShadowBias::normal_offset, 0.0005f), exact) < 0.01);
    CHECK(0.5 * (1.0 - 0.5) ==
          documented_number("61_acne_and_bias", "half"));  // tests/shadows/test_map_bias.cpp measures it
}

TEST_CASE("62_pcf: three by three texels give ten levels and leave as much light as no filter") {
    scene::Scene scene = examples::sunny_table({320, 180});
    scene.shadow.size = 96;
    const auto plain = examples::shadow_factors(scene);
    scene.shadow.filter = ShadowFilter::pcf;
    const auto filtered = examples::shadow_factors(scene);
    std::vector<bool> level(10, false);
    for (const float factor : filtered) {
        const float ninths = 9.0f * factor;
        CHECK(std::abs(ninths - std::round(ninths)) < 1e-5f);
        level[static_cast<std::size_t>(std::lround(ninths))] = true;
    }
    CHECK(std::count(level.begin(), level.end(), true) == documented_number("62_pcf", "levels"));
    CHECK(mean(filtered) == doctest::Approx(mean(plain)).epsilon(0.01));
}

TEST_CASE("63_soft_shadows: the penumbra of an edge is as wide as similar triangles say and rises evenly") {
    CHECK(2.0f * shadows::half_cone(0.1f, 0.6f, 0.0f, false) ==
          doctest::Approx(documented_number("63_soft_shadows", "width")));
    // A sun of width 0.4 straight above a square whose edge is at x = 0.5 and 1 above the floor: from 0.3 to 0.7.
    const scene::Scene scene = scene::read_scene_text(
        "[image]\nsize = [320, 120]\n[camera]\nposition = [4, 0.7, 0]\ntarget = [0.5, 0, 0]\nvertical_fov = 12\n"
        "[[light]]\ndirection = [0, -1, 0]\nshadow = true\n"
        "[shadow]\nfilter = \"pcss\"\nlight_size = 0.4\n[[object]]\nmesh = \"plane\"\nscale = 4\n"
        "[[object]]\nmesh = \"plane\"\nscale = [0.5, 1, 2]\ntranslate = [0, 1, 0]\n",
        "test", "");
    scene::RenderBuffers buffers;
    render(scene,
           make_plan(scene, {scene::find_view("shadow"), scene::find_view("position"), scene::find_view("penumbra")}),
           buffers);
    int in_penumbra = 0;
    for (std::size_t i = 0; i < buffers.views[0].plane_size(); ++i) {
        const float x = buffers.views[1].plane(0)[i], y = buffers.views[1].plane(1)[i],
                    z = buffers.views[1].plane(2)[i];
        const bool inside = x > 0.35f && x < 0.65f && std::abs(y) < 1e-4f && std::abs(z) < 0.3f;
        if (!inside) continue;
        ++in_penumbra;
        CHECK(std::abs(buffers.views[0].values[i] - (x - 0.3f) / 0.4f) < 0.05f);  // a texel is 0.004 of 0.4
        CHECK(buffers.views[2].values[i] == doctest::Approx(0.4).epsilon(0.02));  // asked for: within 20 %
    }
    CHECK(in_penumbra > 500);
}
