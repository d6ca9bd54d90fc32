// The measures of error on pictures small enough to count by hand.
#include <doctest/doctest.h>

#include "raster/visibility.hpp"
#include "shadows/compare.hpp"

using namespace kreda;
using namespace kreda::shadows;

namespace {

/// 8 x 4 samples, all seen; the exact shadow lies on the right half.
struct Strip {
    std::vector<float> depth = std::vector<float>(32, 0.5f);
    std::vector<glm::vec3> position = std::vector<glm::vec3>(32);
    std::vector<float> exact = std::vector<float>(32);

    Strip() {
        for (int i = 0; i < 32; ++i) exact[i] = i % 8 < 4 ? 1.0f : 0.0f;
    }
    [[nodiscard]] VisibleSamples samples() const {
        return {{8, 4}, glm::mat4(1.0f), depth, position};
    }
};

}  // namespace

TEST_CASE("shadow error: nothing is wrong with the exact shadow itself") {
    const Strip strip;
    const ShadowError error = compare_shadows(strip.samples(), strip.exact, strip.exact, 1);
    CHECK(error.visible == 32);
    CHECK(error.misclassified() == 0);
    CHECK(error.rmse == 0.0);
    CHECK(error.edge_length == doctest::Approx(4 * 3.14159265 / 4));  // four pairs along a straight edge
}

TEST_CASE("shadow error: acne and leaks are what is wrong away from the edge") {
    const Strip strip;
    std::vector<float> tested = strip.exact;
    tested[0] = 0.0f;   // far from the edge: acne
    tested[3] = 0.2f;   // at the edge: false shadow there
    tested[15] = 0.9f;  // far on the dark side: a leak
    const ShadowError error = compare_shadows(strip.samples(), strip.exact, tested, 1);
    CHECK(error.false_shadow == 2);
    CHECK(error.acne == 1);
    CHECK(error.false_light == 1);
    CHECK(error.leaks == 1);
    CHECK(error.misclassified_share() == doctest::Approx(3.0 / 32));
    CHECK(error.rmse == doctest::Approx(std::sqrt((1.0 + 0.64 + 0.81) / 32)));
}

TEST_CASE("shadow error: an edge that is off by one sample is displaced by one") {
    const Strip strip;
    std::vector<float> tested = strip.exact;
    for (int y = 0; y < 4; ++y) tested[8 * y + 3] = 0.0f;
    const ShadowError error = compare_shadows(strip.samples(), strip.exact, tested, 2);
    CHECK(error.acne == 0);
    // pi / 4 is right for edges of all directions; along a column it makes the edge shorter than it is.
    CHECK(error.edge_displacement == doctest::Approx(4 / 3.14159265));
}

TEST_CASE("shadow error: what is not seen does not count") {
    Strip strip;
    strip.depth[0] = raster::kClearDepth;
    std::vector<float> tested = strip.exact;
    tested[0] = 0.0f;
    CHECK(compare_shadows(strip.samples(), strip.exact, tested, 1).misclassified() == 0);
    CHECK(compare_shadows(strip.samples(), strip.exact, tested, 1).visible == 31);
    CHECK(error_picture(strip.samples(), strip.exact, tested).rgb(0, 0) == glm::vec3(0.0f));
}

TEST_CASE("shadow error: flicker is the share that changes class") {
    const Strip strip;
    std::vector<float> after = strip.exact;
    after[1] = 0.0f;
    after[2] = 0.6f;
    CHECK(flipped_share(strip.samples(), strip.exact, after) == doctest::Approx(1.0 / 32));
}
