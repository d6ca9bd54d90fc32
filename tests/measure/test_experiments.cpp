// Laws that what experiments measure has to follow.
#include <string>

#include <doctest/doctest.h>

#include "tools/measure/experiment.hpp"

using namespace kreda;
using namespace kreda::tools;

namespace {

Finding quick(std::string_view name) {
    return find_experiment(name)->run({true, 1, {}});
}

double cell(const Finding& finding, const std::string& first, std::size_t column) {
    for (const auto& row : finding.table.rows) {
        if (row[0] == first) return std::stod(row[column]);
    }
    FAIL("no row " << first);
    return 0.0;
}

}  // namespace

TEST_CASE(
    "measure: nine numbers miss of a small sun what the series of a cosine leaves out and of half a sky nothing") {
    const Finding sh9 = quick("sh9");
    // Of a light from one direction E(t) = 1/4 + cos t / 2 + 5/32 (3 cos^2 t - 1): at 90 degrees 3/32 too much. A sun
    // of one degree is half of a degree away from that.                                 Ramamoorthi & Hanrahan 2001
    CHECK(std::abs(cell(sh9, "1", 1) - 100.0 * 3.0 / 32.0) < 0.5);
    CHECK(cell(sh9, "90", 1) < 0.1);  // half a sky has no even degrees beyond 0, and a cosine no odd ones beyond 1
}

TEST_CASE("measure: each bit of sub-pixel positions halves the pixels that change sides") {
    const Finding exactness = quick("exactness");
    double before = exactness.plot.series[0].points[2].y;
    for (std::size_t bits = 3; bits <= 6; ++bits) {
        const double now = exactness.plot.series[0].points[bits].y;
        // A vertex moves by half as much. Some 40 to 5000 of 30,000 pixels are counted: a fifth is three times the
        // noise.
        CHECK(now / before == doctest::Approx(0.5).epsilon(0.2));
        before = now;
    }
}

TEST_CASE("measure: one shading point a pixel is the picture itself and fewer miss more") {
    const Finding rate = quick("shading_rate");
    CHECK(cell(rate, "1 x 1", 3) == 0.0);
    CHECK(cell(rate, "2 x 2", 3) < cell(rate, "4 x 4", 3));
    // A square of four pixels has one point, or one for each object in it: at least a quarter of all.
    CHECK(cell(rate, "2 x 2", 2) >= 0.25 * cell(rate, "1 x 1", 2));
    CHECK(cell(rate, "2 x 2", 2) < 0.3 * cell(rate, "1 x 1", 2));
}
