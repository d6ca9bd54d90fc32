// Laws about 93: what a shadow map's size and bias do to its error, against a ray from every pixel.
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "course.hpp"
#include "examples/table_scene.hpp"
#include "scene/render/render.hpp"

using namespace kreda;
using namespace kreda::tests;
using shadows::ShadowBias;
using shadows::ShadowFilter;

namespace {

/// The table of the page, one picture a setting, and the same by rays.
class Measured {
public:
    Measured() {
        scene::Scene rays = scene_;
        rays.shadow.method = shadows::ShadowMethod::exact;
        exact_ = examples::shadow_factors(rays);
        scene::RenderBuffers buffers;
        render(rays, make_plan(rays, {scene::find_view("depth")}), buffers);
        depth_ = buffers.views[0].values;
    }

    /// Of the pixels that see something, how many are wrong?
    double wrong_percent(int size, ShadowBias bias, ShadowFilter filter = ShadowFilter::none) {
        scene_.shadow.size = size;
        scene_.shadow.bias = bias;
        scene_.shadow.filter = filter;
        const auto tested = examples::shadow_factors(scene_);
        int wrong = 0, visible = 0;
        for (std::size_t i = 0; i < exact_.size(); ++i) {
            if (depth_[i] == 1.0f) continue;
            ++visible;
            wrong += (tested[i] < 0.5f) != (exact_[i] < 0.5f);
        }
        return 100.0 * wrong / visible;
    }

private:
    static scene::Scene softly_lit() {
        scene::Scene scene = examples::sunny_table({640, 360});
        scene.shadow.light_size = 0.02f;
        return scene;
    }
    scene::Scene scene_ = softly_lit();
    raster::AlignedVector<float> exact_, depth_;
};

}  // namespace

TEST_CASE(
    "93_shadow_resolution: with a bias that suits it the error of a map is about in inverse proportion to its size") {
    Measured measured;
    for (const ShadowBias bias : {ShadowBias::slope, ShadowBias::normal_offset}) {
        double before = 1.0;
        for (const int size : {256, 512, 1024, 2048}) {
            const double wrong = measured.wrong_percent(size, bias);
            CAPTURE(size);
            CHECK(wrong < before);
            before = wrong;
        }
        // An edge is off by a share of a texel, whatever the texel: 8 times the size, an eighth of the error. Of the
        // 66,000 pixels six are wrong at 2048 texels, which is as exact as one may count: half to twice.
        const double ratio = measured.wrong_percent(256, bias) / measured.wrong_percent(2048, bias);
        CHECK(ratio > 4.0);
        CHECK(ratio < 16.0);
    }
}

TEST_CASE("93_shadow_resolution: no size mends a map without bias and only size mends a constant one") {
    // Without bias a texel that is lit darkens half of itself, however small it is.
    Measured measured;
    const double coarse = measured.wrong_percent(256, ShadowBias::none);
    CHECK(measured.wrong_percent(2048, ShadowBias::none) == doctest::Approx(coarse).epsilon(0.03));
    CHECK(measured.wrong_percent(2048, ShadowBias::constant) <
          0.25 * measured.wrong_percent(512, ShadowBias::constant));
}

TEST_CASE("93_shadow_resolution: averaging does not move the edges where the bias is right") {
    Measured measured;
    const double seven_pixels = 100.0 * 7.0 / 65866.0;  // of those that see something
    for (const int size : {256, 512}) {
        const double plain = measured.wrong_percent(size, ShadowBias::slope);
        for (const ShadowFilter filter : {ShadowFilter::pcf, ShadowFilter::pcss}) {
            CHECK(std::abs(measured.wrong_percent(size, ShadowBias::slope, filter) - plain) < 1.01 * seven_pixels);
        }
    }
}

TEST_CASE("93_shadow_resolution: shares of wrong pixels are those on the page") {
    Measured measured;
    const std::pair<const char*, ShadowBias> rows[] = {{"no bias", ShadowBias::none},
                                                       {"constant 0.0005", ShadowBias::constant},
                                                       {"slope (the default)", ShadowBias::slope},
                                                       {"along the normal", ShadowBias::normal_offset}};
    for (const auto& [row, bias] : rows) {
        CAPTURE(std::string(row));
        const std::vector<QuotedNumber> quoted = documented_row("93_shadow_resolution", "no filter", row);
        REQUIRE(quoted.size() == 4);
        std::size_t cell = 0;
        for (const int size : {256, 512, 1024, 2048}) {
            const double percent = measured.wrong_percent(size, bias);
            CAPTURE(percent);
            CHECK(rounds_to(percent, quoted[cell++]));
        }
    }
}
