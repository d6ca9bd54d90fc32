// From clip space to the pixel grid: divide, snap, edge functions.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "raster/screen.hpp"
#include "tests/raster/random_scenes.hpp"

using namespace kreda::tests;

TEST_CASE("Corners and centre of clip space land on the corners and centre of the image: y turned and row 0 on top") {
    const Viewport viewport{200, 100};
    const ScreenVertex centre = to_screen({0, 0, 0, 1}, viewport);
    CHECK(centre.x == 100 * 256);
    CHECK(centre.y == 50 * 256);
    CHECK(centre.z == 0.5f);
    CHECK(centre.inv_w == 1.0f);
    const ScreenVertex top_left = to_screen({-2, 2, -2, 2}, viewport);  // w = 2: the divide
    CHECK(top_left.x == 0);
    CHECK(top_left.y == 0);
    CHECK(top_left.z == 0.0f);
    CHECK(top_left.inv_w == 0.5f);
    const ScreenVertex bottom_right = to_screen({3, -3, 3, 3}, viewport);
    CHECK(bottom_right.x == 200 * 256);
    CHECK(bottom_right.y == 100 * 256);
    CHECK(bottom_right.z == 1.0f);
}

TEST_CASE("Snap to 1/256 sample: nearest and halves go up on both sides of zero") {
    const Viewport viewport{2, 2};  // x_window = x + 1, exactly
    const auto snapped = [&](float x_window) { return to_screen({x_window - 1.0f, 0, 0, 1}, viewport).x; };
    CHECK(snapped(1.0f) == 256);
    CHECK(snapped(1.0f + 0.4f / 256) == 256);
    CHECK(snapped(1.0f + 0.5f / 256) == 257);
    CHECK(snapped(1.0f + 0.6f / 256) == 257);
    CHECK(snapped(-1.0f - 0.4f / 256) == -256);
    CHECK(snapped(-1.0f - 0.5f / 256) == -256);  // up is towards +infinity, so that a mesh may move by whole pixels
    CHECK(snapped(-1.0f - 0.6f / 256) == -257);
}

TEST_CASE("Snap is at most half a step from the exact place and over the guard band the float adds less than that") {
    Random random(1);
    const Viewport viewport{1920, 1080};
    double worst_inside = 0.0, worst_band = 0.0;
    for (int i = 0; i < 100000; ++i) {
        const bool inside = random.integer(0, 1) == 0;
        const float w = std::exp2(random.real(-10.0f, 10.0f));
        const float reach = inside ? 1.0f : guard_band_ndc(viewport.width);
        const glm::vec4 clip(random.real(-reach, reach) * w, 0.0f, 0.0f, w);
        const double exact = (double{clip.x} / double{w} + 1.0) * 960.0 * 256.0;
        double& worst = inside ? worst_inside : worst_band;
        worst = std::max(worst, std::abs(to_screen(clip, viewport).x - exact));
    }
    // x_window is a float: four roundings of 2^-24 * 1920 * 256 = 0.03 steps each on the image, ...
    CHECK(worst_inside < 0.5 + 4 * 0.03);
    // ... and of 2^-24 * 17 * 960 * 256 = 0.25 at the ends of the band.
    CHECK(worst_band < 0.5 + 4 * 0.25);
}

TEST_CASE("Depth stays in 0..1 for every vertex between the near and far planes") {
    Random random(2);
    const Viewport viewport{64, 64};
    int outside = 0;
    for (int i = 0; i < 100000; ++i) {
        const float w = std::exp2(random.real(-20.0f, 20.0f));
        for (const float z : {-w, w, std::nextafter(-w, 0.0f), std::nextafter(w, 0.0f)}) {
            const float depth = to_screen({0, 0, z, w}, viewport).z;
            outside += depth >= 0.0f && depth <= 1.0f ? 0 : 1;
        }
        CHECK(to_screen({0, 0, -w, w}, viewport).z <= 6e-8f);  // 1/w and z/w are rounded: half an ulp of 1 each
        CHECK(to_screen({0, 0, w, w}, viewport).z >= 1.0f - 6e-8f);
    }
    CHECK(outside == 0);
}

TEST_CASE("Guard band: NaN infinity and w not above zero are outside and its border is inside") {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    CHECK(inside_guard_band({0, 0, 0, 1}, 2, 3));
    CHECK(inside_guard_band({2, -3, 1, 1}, 2, 3));
    CHECK_FALSE(inside_guard_band({2.001f, 0, 0, 1}, 2, 3));
    CHECK_FALSE(inside_guard_band({0, -3.001f, 0, 1}, 2, 3));
    CHECK_FALSE(inside_guard_band({0, 0, 1.001f, 1}, 2, 3));
    CHECK_FALSE(inside_guard_band({0, 0, -1.001f, 1}, 2, 3));
    CHECK_FALSE(inside_guard_band({0, 0, 0, 0}, 2, 3));
    CHECK_FALSE(inside_guard_band({0, 0, 0, -1}, 2, 3));
    CHECK_FALSE(inside_guard_band({0, 0, 0, 1e-40f}, 2, 3));  // 1/w would be infinite
    for (const float bad : {nan, inf, -inf}) {
        for (int component = 0; component < 4; ++component) {
            glm::vec4 p(0, 0, 0, 1);
            p[component] = bad;
            if (component == 3 && bad == inf) continue;  // w = inf: a point at the middle of the screen, far away
            CHECK_FALSE(inside_guard_band(p, 2, 3));
        }
    }
    CHECK_FALSE(inside_guard_band({0, 0, 0, inf}, 2, 3));
}

TEST_CASE("Edge steps fit the tile's 32 bits for every image size") {
    // rasterize_tile.cpp needs corners less than 2^23 steps apart.
    for (const int side : {1, 2, 3, 100, 1920, 16383, kMaxImageSide}) {
        CAPTURE(side);
        const Viewport viewport{side, side};
        const float guard = guard_band_ndc(side);
        int exponent = 0;
        CHECK(std::frexp(guard, &exponent) == 0.5f);  // a power of two: guard * w does not round
        CHECK(guard >= 1.0f);                         // the image itself is inside
        CHECK(guard * 0.5f * static_cast<float>(side) <= kGuardBand);
        for (const float w : {1.0f, 0.1f, 3e-7f, 7e9f}) {
            const float reach = guard * w;
            REQUIRE(inside_guard_band({reach, reach, 0, w}, guard, guard));
            const ScreenVertex high = to_screen({reach, -reach, 0, w}, viewport);
            const ScreenVertex low = to_screen({-reach, reach, 0, w}, viewport);
            CHECK(high.x - low.x < 1 << 23);
            CHECK(high.y - low.y < 1 << 23);
        }
    }
}

TEST_CASE("Edge function by hand: twice the area and positive on the right of a downward screen's edge") {
    // a (0,0) -> b (4,0) runs right along the top; y grows downwards, so (1,3) below it is on its right.
    CHECK(edge_function(0, 0, 4, 0, 1, 3) == 12);
    CHECK(edge_function(0, 0, 4, 0, 1, -3) == -12);
    CHECK(edge_function(0, 0, 4, 0, 9, 0) == 0);
    CHECK(edge_function(4, 0, 0, 0, 1, 3) == -12);
    // 2^31 apart: exact where 32 bits, and a double's 53, would not be.
    const std::int64_t far = (std::int64_t{1} << 30) + 1;
    CHECK(edge_function(-far, -far, far, far, far, -far + 1) == -4 * far * far + 2 * far);
}

TEST_CASE("Edge functions of a point sum to twice the area and turning an edge turns the sign") {
    Random random(3);
    for (int i = 0; i < 10000; ++i) {
        const auto c = [&] { return std::int64_t{random.integer(-4194304, 4194304)}; };
        const std::int64_t ax = c(), ay = c(), bx = c(), by = c(), cx = c(), cy = c(), px = c(), py = c();
        const std::int64_t sum = edge_function(ax, ay, bx, by, px, py) + edge_function(bx, by, cx, cy, px, py) +
                                 edge_function(cx, cy, ax, ay, px, py);
        REQUIRE(sum == edge_function(ax, ay, bx, by, cx, cy));
        REQUIRE(edge_function(bx, by, ax, ay, px, py) == -edge_function(ax, ay, bx, by, px, py));
    }
}

TEST_CASE("Top-left: of an edge and the same edge turned exactly one is top or left") {
    for (int x = -3; x <= 3; ++x) {
        for (int y = -3; y <= 3; ++y) {
            if (x == 0 && y == 0) continue;
            CHECK(is_top_left(x, y) != is_top_left(-x, -y));
        }
    }
    CHECK(is_top_left(1, 0));   // to the right: the top edge of a clockwise triangle
    CHECK(is_top_left(0, -1));  // upwards: a left edge
    CHECK(is_top_left(5, -1));
    CHECK_FALSE(is_top_left(-1, 0));
    CHECK_FALSE(is_top_left(0, 1));
}

TEST_CASE("Top-left: the least E that is inside is 0 or 1 in every width of integers") {
    for (int x = -3; x <= 3; ++x) {
        for (int y = -3; y <= 3; ++y) {
            const int least = y < 0 || (y == 0 && x > 0) ? 0 : 1;
            CHECK(least_inside(x, y) == least);
            CHECK(least_inside(std::int64_t{x} << 40, std::int64_t{y} << 40) == least);
        }
    }
}

TEST_CASE("Top-left: by hand a square of two triangles covers the centres on its upper and left sides and no others") {
    // Corners in the centres of samples 0 and 2; the diagonal runs through the centre of sample (1, 1).
    const auto corner = [](int x, int y) {
        ScreenVertex v;
        v.x = x * kSubpixels + kPixelCentre;
        v.y = y * kSubpixels + kPixelCentre;
        return v;
    };
    const ScreenVertex a = corner(0, 0), b = corner(2, 0), c = corner(2, 2), d = corner(0, 2);
    for (int y = 0; y <= 2; ++y) {
        for (int x = 0; x <= 2; ++x) {
            CAPTURE(x);
            CAPTURE(y);
            // Whatever corner comes first, each edge has its own say.
            const bool upper = covers_sample(a, b, c, x, y), lower = covers_sample(a, c, d, x, y);
            CHECK(upper == covers_sample(b, c, a, x, y));
            CHECK(upper == covers_sample(c, a, b, x, y));
            CHECK(lower == covers_sample(c, d, a, x, y));
            CHECK(lower == covers_sample(d, a, c, x, y));
            CHECK(static_cast<int>(upper) + static_cast<int>(lower) == (x < 2 && y < 2 ? 1 : 0));
        }
    }
    CHECK(covers_sample(a, b, c, 1, 0));        // on its top edge
    CHECK(covers_sample(a, c, d, 0, 1));        // on its left edge
    CHECK(covers_sample(a, b, c, 1, 1));        // the diagonal goes up to the left: the left edge of the upper triangle
    CHECK_FALSE(covers_sample(a, c, d, 1, 1));  // and the right one of the lower
}
