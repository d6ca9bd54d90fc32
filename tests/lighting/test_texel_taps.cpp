// Bilinear weights and sums of texels: numbers worked by hand, and a batch against one point at a time.
#include <memory>
#include <vector>

#include <doctest/doctest.h>

#include "lighting/environment/texel_taps.hpp"

using namespace kreda;
using namespace kreda::lighting;

namespace {

/// A grid of texels (r, g, b, 0) = (x + 2y, 10x, y), `width` of them a row.
std::vector<float> ramp(int width, int height) {
    std::vector<float> texels;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (const int value : {x + 2 * y, 10 * x, y, 0}) texels.push_back(static_cast<float>(value));
        }
    }
    return texels;
}

}  // namespace

TEST_CASE("taps: the four weights are products of the distances to the opposite texels") {
    const TexelTap tap = bilinear_tap(12, 40, 0.25f, 0.5f, 2.0f);
    CHECK(tap.first == 12);
    CHECK(tap.next_row == 40);
    CHECK(tap.w_00 == 0.75f);  // 0.75 x 0.5 x 2
    CHECK(tap.w_10 == 0.25f);
    CHECK(tap.w_01 == 0.75f);
    CHECK(tap.w_11 == 0.25f);
}

TEST_CASE("taps: on a texel's centre only that texel counts and all weights together are the share") {
    const TexelTap corner = bilinear_tap(0, 8, 0.0f, 0.0f, 1.0f);
    CHECK(corner.w_00 == 1.0f);
    CHECK(corner.w_10 == 0.0f);
    CHECK(corner.w_01 == 0.0f);
    CHECK(corner.w_11 == 0.0f);
    for (const float fx : {0.0f, 0.1f, 0.7f, 1.0f}) {
        for (const float fy : {0.0f, 0.3f, 1.0f}) {
            const TexelTap tap = bilinear_tap(0, 8, fx, fy, 0.4f);
            CHECK(tap.w_00 + tap.w_10 + tap.w_01 + tap.w_11 == doctest::Approx(0.4).epsilon(1e-6));
        }
    }
}

TEST_CASE("taps: a linear ramp is reproduced between its texels") {
    const std::vector<float> texels = ramp(3, 2);
    for (const float fx : {0.0f, 0.25f, 0.9f}) {
        for (const float fy : {0.0f, 0.5f, 1.0f}) {
            const glm::vec3 sum = weighted_sum(texels.data(), bilinear_tap(4, 12, fx, fy, 1.0f));  // texel (1, 0)
            CHECK(sum.x == doctest::Approx(1.0 + fx + 2.0 * fy));
            CHECK(sum.y == doctest::Approx(10.0 * (1.0 + fx)));
            CHECK(sum.z == doctest::Approx(fy));
        }
    }
}

TEST_CASE("taps: a batch reads what one point reads bit for bit on one level and on two") {
    const std::vector<float> texels = ramp(7, 5);
    const auto scratch = std::make_unique<TapScratch>();
    const auto colors = std::make_unique<raster::Channel3>();
    const int lanes = raster::lanes_for(20);
    const auto tap_of = [](int i, float share) {
        const int x = i % 6, y = i % 4;
        return bilinear_tap(4 * (7 * y + x), 28, 0.05f * static_cast<float>(i), 1.0f - 0.03f * static_cast<float>(i),
                            share);
    };
    for (int i = 0; i < lanes; ++i) {
        scratch->taps[0].set(i, tap_of(i, 0.3f));
        scratch->taps[1].set(i, tap_of(i + 3, 0.7f));
    }
    for (const int levels : {1, 2}) {
        read_taps(texels.data(), lanes, levels, *scratch);
        split_texels(lanes, *scratch, *colors);
        for (int i = 0; i < 20; ++i) {
            glm::vec3 expected = weighted_sum(texels.data(), tap_of(i, 0.3f));
            if (levels == 2) expected += weighted_sum(texels.data(), tap_of(i + 3, 0.7f));
            CHECK(colors->at(i) == expected);
        }
    }
}
