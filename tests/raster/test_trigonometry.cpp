// Angles without the C library against the C library in double, within the bounds that the docstrings state.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <doctest/doctest.h>

#include "raster/trigonometry.hpp"

namespace raster = kreda::raster;
using std::numbers::pi;

TEST_CASE("sin_cos_of_turns: within 1.1e-7 of double on both sides of zero") {
    double worst = 0.0;
    for (int i = -1000003; i <= 1000003; ++i) {
        const float turns = static_cast<float>(i) / 1000003.0f;
        const raster::SinCos got = raster::sin_cos_of_turns(turns);
        const double angle = 2.0 * pi * double(turns);
        worst =
            std::max({worst, std::abs(double(got.sin) - std::sin(angle)), std::abs(double(got.cos) - std::cos(angle))});
    }
    CHECK(worst <= 1.1e-7);
    CHECK(worst > 1e-9);  // floats round: a smaller error would mean that nothing was measured
}

TEST_CASE("sin_cos_of_turns: quarter turns are exact and whole turns change nothing") {
    const float sines[] = {0.0f, 1.0f, 0.0f, -1.0f};
    const float cosines[] = {1.0f, 0.0f, -1.0f, 0.0f};
    for (int i = -4000; i <= 4000; ++i) {
        CAPTURE(i);
        const raster::SinCos got = raster::sin_cos_of_turns(0.25f * static_cast<float>(i));
        CHECK(got.sin == sines[i & 3]);
        CHECK(got.cos == cosines[i & 3]);
    }
    for (const float whole : {1.0f, -1.0f, 1024.0f, -65536.0f}) {  // the sum with 5/32 is a float, too
        CHECK(raster::sin_cos_of_turns(whole + 0.15625f).sin == raster::sin_cos_of_turns(0.15625f).sin);
        CHECK(raster::sin_cos_of_turns(whole + 0.15625f).cos == raster::sin_cos_of_turns(0.15625f).cos);
    }
}

TEST_CASE("atan2_in_turns: within 6e-8 turns of double for points of every size and quadrant") {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> component(-1.0f, 1.0f);
    std::uniform_int_distribution<int> exponent(-60, 60);
    double worst = 0.0;
    for (int i = 0; i < 1000000; ++i) {
        const int size = exponent(random);
        const float y = std::ldexp(component(random), size), x = std::ldexp(component(random), size);
        const double want = std::atan2(double(y), double(x)) / (2.0 * pi);
        worst = std::max(worst, std::abs(double(raster::atan2_in_turns(y, x)) - want));
    }
    CHECK(worst <= 6.0e-8);
    CHECK(worst > 1e-9);
}

TEST_CASE("atan2_in_turns: the axes and the diagonals are exact and the origin is 0") {
    CHECK(raster::atan2_in_turns(0.0f, 0.0f) == 0.0f);
    CHECK(raster::atan2_in_turns(0.0f, 3.0f) == 0.0f);
    CHECK(raster::atan2_in_turns(3.0f, 0.0f) == 0.25f);
    CHECK(raster::atan2_in_turns(0.0f, -3.0f) == 0.5f);
    CHECK(raster::atan2_in_turns(-3.0f, 0.0f) == -0.25f);
    CHECK(raster::atan2_in_turns(2.0f, 2.0f) == 0.125f);
    CHECK(raster::atan2_in_turns(2.0f, -2.0f) == 0.375f);
    CHECK(raster::atan2_in_turns(-2.0f, -2.0f) == -0.375f);
    CHECK(raster::atan2_in_turns(-2.0f, 2.0f) == -0.125f);
}

TEST_CASE("atan_in_double: within 4e-16 of long double from -1 to 1") {
    long double worst = 0.0L;
    for (int i = -100003; i <= 100003; ++i) {
        const double x = i / 100003.0;
        worst = std::max(worst, std::abs(raster::atan_in_double(x) - std::atan(static_cast<long double>(x))));
    }
    CHECK(static_cast<double>(worst) <= 4e-16);
}

TEST_CASE("cos_of_turns_in_double: agrees with the C library over half a turn") {
    double worst = 0.0;
    for (int i = 0; i <= 100003; ++i) {
        const double turns = 0.5 * i / 100003.0;
        const long double want = std::cos(2.0L * std::numbers::pi_v<long double> * static_cast<long double>(turns));
        worst = std::max(worst, static_cast<double>(std::abs(raster::cos_of_turns_in_double(turns) - want)));
    }
    CHECK(worst <= 2e-16);
    CHECK(raster::cos_of_turns_in_double(0.0) == 1.0);
    CHECK(raster::cos_of_turns_in_double(0.25) == 0.0);
    CHECK(raster::cos_of_turns_in_double(0.5) == -1.0);
}
