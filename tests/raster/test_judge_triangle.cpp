// What is left out is left out rightly: every judgement against edge functions in 64 bits, sample by sample.
#include <doctest/doctest.h>

#include <random>
#include <utility>

#include "raster/judge_triangle.hpp"

using namespace kreda::raster;

namespace {

constexpr Viewport kImage{40, 30};

/// Corners around a random sample of the image or just beside it, on the 1/256 grid; every fourth one on a sample
/// centre or half-way, where edges and centres meet.
ScreenVertex corner_near(int x, int y, int reach, std::mt19937& random) {
    std::uniform_int_distribution<int> offset(-reach * kSubpixels, reach * kSubpixels);
    ScreenVertex v;
    v.x = x * kSubpixels + offset(random);
    v.y = y * kSubpixels + offset(random);
    if (random() % 4 == 0) {
        v.x = v.x & -kPixelCentre;
        v.y = v.y & -kPixelCentre;
    }
    return v;
}

/// How many samples of the image a triangle covers; it is turned clockwise first.
int samples_covered(const ScreenVertex& a, ScreenVertex b, ScreenVertex c) {
    if (edge_function(a.x, a.y, b.x, b.y, c.x, c.y) < 0) std::swap(b, c);
    int covered = 0;
    for (int y = 0; y < kImage.height; ++y) {
        for (int x = 0; x < kImage.width; ++x) covered += covers_sample(a, b, c, x, y);
    }
    return covered;
}

}  // namespace

TEST_CASE("A triangle that covers a sample is drawn and a small one in the image that covers none is not") {
    std::mt19937 random(2024);
    int drawn = 0, left_out = 0;
    for (int k = 0; k < 20000; ++k) {
        const int x = static_cast<int>(random() % (kImage.width + 4)) - 2;
        const int y = static_cast<int>(random() % (kImage.height + 4)) - 2;
        const int reach = 1 + static_cast<int>(random() % 3);
        const ScreenVertex a = corner_near(x, y, reach, random), b = corner_near(x, y, reach, random),
                           c = corner_near(x, y, reach, random);
        const ScreenPoint pa = point_of(a), pb = point_of(b), pc = point_of(c);
        const Judgement judgement = judge(pa, pb, pc, CullMode::none, kImage);
        const Fate fate = look_closer(pa, pb, pc, judgement);
        const std::int64_t area = edge_function(a.x, a.y, b.x, b.y, c.x, c.y);
        CHECK((fate == Fate::degenerate) == (area == 0));
        if (area == 0) continue;
        CHECK(judgement.front == (area < 0));
        const int covered = samples_covered(a, b, c);
        if (covered > 0) CHECK(fate == Fate::drawn);
        const bool inside = x >= 4 && x < kImage.width - 4 && y >= 4 && y < kImage.height - 4;
        if (covered == 0 && inside && fits_block(pa, pb, pc)) CHECK(fate == Fate::outside);
        drawn += fate == Fate::drawn;
        left_out += fate == Fate::outside;
    }
    CHECK(drawn > 5000);
    CHECK(left_out > 1000);
}

TEST_CASE("A judgement's samples are those whose centres lie in the triangle's box and in the image") {
    // In samples: x from 1.5 (a centre) to 3.4, y from -2 to 1.6.
    const ScreenPoint a{384, -512}, b{870, 0}, c{400, 410};
    const Judgement judgement = judge(a, b, c, CullMode::none, kImage);
    CHECK(judgement.fate == Fate::drawn);
    CHECK(judgement.x.first == 1);
    CHECK(judgement.x.last == 2);
    CHECK(judgement.y.first == 0);
    CHECK(judgement.y.last == 1);
}

TEST_CASE("Culling looks at the side that faces the eye") {
    const ScreenPoint a{0, 0}, b{2560, 0}, c{0, 2560};  // clockwise with y down: seen from behind
    CHECK(judge(a, b, c, CullMode::back, kImage).fate == Fate::culled);
    CHECK(judge(a, b, c, CullMode::front, kImage).fate == Fate::drawn);
    CHECK(judge(a, c, b, CullMode::back, kImage).fate == Fate::drawn);
    CHECK(judge(a, c, b, CullMode::front, kImage).fate == Fate::culled);
    const ScreenPoint nowhere{kNeedsClip, 0};
    CHECK(judge(nowhere, b, c, CullMode::back, kImage).fate == Fate::needs_clip);
    CHECK(judge(nowhere, nowhere, nowhere, CullMode::back, kImage).fate == Fate::needs_clip);
}
