// The steps of the depth formats against closed forms and against brute force; the pictures of 95_depth_precision.
#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "course.hpp"
#include "examples/draw.hpp"
#include "raster/depth_formats.hpp"

using namespace kreda;
using namespace kreda::tests;
using raster::DepthFormat;
using raster::stored_depth;

namespace {

constexpr DepthFormat kAll[] = {DepthFormat::unorm16, DepthFormat::unorm24, DepthFormat::float32,
                                DepthFormat::reversed_float32};

/// The least gap behind z that is stored differently, found by halving.
double gap_by_trying(DepthFormat format, double z, double n, double f) {
    const double here = stored_depth(format, z, n, f);
    double same = 0.0, different = f - z;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (same + different);
        (stored_depth(format, z + middle, n, f) == here ? same : different) = middle;
    }
    return different;
}

/// Share of a panel's pixels in a row, counted from its top, that show a carpet.
double carpet_in_row(const raster::Image& panel, int y) {
    int found = 0;
    for (int x = 0; x < panel.width; ++x) found += glm::distance(panel.rgb(x, y), examples::kSlate) > 0.02f ? 1 : 0;
    return static_cast<double>(found) / panel.width;
}

}  // namespace

TEST_CASE("95_depth_precision: the documented steps follow from the closed forms") {
    const double n = 0.1, f = 1000.0, z = 500.0;
    const double u24 = z * z * (f - n) / (f * n) / 16777215.0;
    CHECK(documented_number("95_depth_precision", "u24_at_500") == doctest::Approx(u24).epsilon(0.002));
    CHECK(documented_number("95_depth_precision", "float_at_500") ==
          doctest::Approx(depth_step(DepthFormat::float32, z, n, f)).epsilon(0.002));
    CHECK(documented_number("95_depth_precision", "reversed_at_500") ==
          doctest::Approx(depth_step(DepthFormat::reversed_float32, z, n, f)).epsilon(0.002));
    CHECK(raster::window_depth(2.0 * n, n, f) == doctest::Approx(0.5).epsilon(0.001));  // half of the values up to 2n
}

TEST_CASE("95_depth_precision: a near plane of 1e-7 stores everything beyond the page's distance as one depth") {
    // 1 - n / z rounds to 1 where n / z < 2^-25.
    const double z = 1e-7 * std::exp2(25.0);
    CHECK(rounds_to(z, quoted_number("95_depth_precision", "lost")));
    CHECK(stored_depth(DepthFormat::float32, 1.01 * z, 1e-7, 1e9) == 1.0);
    CHECK(stored_depth(DepthFormat::float32, 0.99 * z, 1e-7, 1e9) < 1.0);
}

TEST_CASE("95_depth_precision: trying finds no gap larger than a step and rarely one much smaller") {
    for (const DepthFormat format : kAll) {
        CAPTURE(static_cast<int>(format));
        double sum = 0.0;
        int tried = 0;
        for (double z = 1.0; z < 400.0; z *= 1.037, ++tried) {
            CAPTURE(z);
            const double step = depth_step(format, z, 0.1, 1000.0);
            const double gap = gap_by_trying(format, z, 0.1, 1000.0);
            // Behind z the slope is less by up to (step / z)^2-ish, and a float's step may double at a power of two.
            CHECK(gap <= step * (2.0 + 2.0 * step / z));
            sum += gap / step;
        }
        CHECK(sum / tried == doctest::Approx(0.5).epsilon(0.25));  // somewhere within a step: half of one on average
    }
}

TEST_CASE("95_depth_precision: no format stores the farther surface as the nearer one") {
    for (const DepthFormat format : kAll) {
        CAPTURE(static_cast<int>(format));
        for (double z = 0.011; z < 9000.0; z *= 1.003) {
            const double near_one = stored_depth(format, z, 0.01, 1e4);
            CHECK_FALSE(is_nearer(format, stored_depth(format, z * 1.00001, 0.01, 1e4), near_one));
        }
    }
}

TEST_CASE("95_depth_precision: a reversed float tells surfaces apart to one part in four million everywhere") {
    for (double z = 0.02; z < 9999.0; z *= 1.01) {
        CAPTURE(z);
        // 2^-23 of z, and a little more next to the far plane, where 1 - d bends to 0
        CHECK(depth_step(DepthFormat::reversed_float32, z, 0.01, 1e4) <= z * std::exp2(-23.0) * 1.001);
    }
}

TEST_CASE("95_depth_precision: carpets vanish where a step is larger than their gap") {
    const auto panel = [](int i) { return linear_panel("95_depth_precision/carpets", 2, 2, i); };
    const raster::Image bits24 = panel(1), reversed = panel(3);
    double everywhere = 0.0, kept = 0.0;
    for (int y = 30; y < 65; ++y) {  // near rows: z < 100, where a gap of 0.1 % is more than a step
        everywhere += carpet_in_row(reversed, y);
        kept += carpet_in_row(bits24, y);
        CHECK(carpet_in_row(panel(0), y) < 0.05);
    }
    CHECK(kept == everywhere);
    CHECK(everywhere > 5.0);
    for (int y = 1; y < 4; ++y) {  // far rows: z > 900, where 24 bits step by 4.8 and the gap is 0.9
        CHECK(carpet_in_row(bits24, y) < carpet_in_row(reversed, y) + 1e-9);
    }
    CHECK(carpet_in_row(bits24, 2) + carpet_in_row(bits24, 3) <
          carpet_in_row(reversed, 2) + carpet_in_row(reversed, 3));
}
