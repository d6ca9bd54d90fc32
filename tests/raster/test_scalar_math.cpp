// exp2, log2, exp, pow against the C library in double or long double, and the laws of the small helpers.
#include "raster/scalar_math.hpp"

#include "raster/platform.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

namespace raster = kreda::raster;

namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kSmallestSubnormal = 0x1p-149f;

std::uint32_t bits_of(float x) {
    return std::bit_cast<std::uint32_t>(x);
}

/// Distance of `got` from the true value in units of the last place: the spacing of floats around the true value.
double ulps(float got, double want) {
    int exponent = 0;
    std::frexp(want, &exponent);
    return std::fabs(static_cast<double>(got) - want) / std::ldexp(1.0, exponent - 24);
}

struct Worst {
    double error = 0.0;
    float at = 0.0f;
    int count = 0;

    void add(double e, float x) {
        ++count;
        if (!(e <= error)) {  // a NaN error counts, too
            error = e;
            at = x;
        }
    }
};

/// Calls visit(x) for every 257th bit pattern: all signs, exponents, subnormals and NaNs.
/// 257 is prime to the powers of two, so the low mantissa bits take all their values.
template <typename Visit>
void for_every_257th_float(Visit visit) {
    for (std::uint64_t bits = 0; bits < (std::uint64_t{1} << 32); bits += 257) {
        visit(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    }
}

KREDA_BATCH_LOOP void exp2_batch(const float* __restrict x, float* __restrict out, int n) {
    for (int i = 0; i < n; ++i) out[i] = raster::exp2(x[i]);
}
KREDA_BATCH_LOOP void exp_batch(const float* __restrict x, float* __restrict out, int n) {
    for (int i = 0; i < n; ++i) out[i] = raster::exp(x[i]);
}
KREDA_BATCH_LOOP void log2_batch(const float* __restrict x, float* __restrict out, int n) {
    for (int i = 0; i < n; ++i) out[i] = raster::log2(x[i]);
}
KREDA_BATCH_LOOP void pow_batch(const float* __restrict x, float y, float* __restrict out, int n) {
    for (int i = 0; i < n; ++i) out[i] = raster::pow(x[i], y);
}

}  // namespace

// ------------------------------------------------------------------------------------------------------- exp2

TEST_CASE("exp2 is within 0.83 ulp over the whole range and 0 or inf outside") {
    Worst worst;
    int wrong_outside = 0;
    for_every_257th_float([&](float x) {
        const float got = raster::exp2(x);
        if (std::isnan(x))
            wrong_outside += !std::isnan(got);
        else if (x >= 128.0f)
            wrong_outside += got != kInf;
        else if (x < -126.0f)
            wrong_outside += bits_of(got) != 0;
        else
            worst.add(ulps(got, std::exp2(static_cast<double>(x))), x);
    });
    CAPTURE(worst.at);
    CHECK(worst.count > 8'000'000);
    CHECK(worst.error <= 0.83);  // the stated bound; all floats were checked once: 0.823
    CHECK(wrong_outside == 0);
}

TEST_CASE("exp2 of an integer is exact and log2 takes it back") {
    for (int k = -126; k <= 127; ++k) {
        CAPTURE(k);
        const float power = std::ldexp(1.0f, k);
        CHECK(raster::exp2(static_cast<float>(k)) == power);
        CHECK(raster::log2(power) == static_cast<float>(k));
        CHECK(raster::log2(raster::exp2(static_cast<float>(k))) == static_cast<float>(k));
    }
}

TEST_CASE("exp2 never decreases") {
    // A piece is one nearest integer: the seams lie at the half integers; the integers are looked at as well.
    int decreases = 0;
    for (int twice = -2 * 126 + 1; twice < 2 * 128; ++twice) {
        const float seam = 0.5f * static_cast<float>(twice);
        float x = seam;
        for (int step = 0; step < 1000; ++step) x = std::nextafter(x, -kInf);
        for (int step = 0; step < 2000; ++step) {
            const float next = std::nextafter(x, kInf);
            decreases += raster::exp2(next) < raster::exp2(x);
            x = next;
        }
    }
    for (std::uint32_t bits = bits_of(-1.0f); bits > bits_of(-0x1p-26f); bits -= 29) {  // where it was hard: below 1
        decreases += raster::exp2(std::bit_cast<float>(bits - 29)) < raster::exp2(std::bit_cast<float>(bits));
    }
    CHECK(decreases == 0);
}

TEST_CASE("exp2 special values") {
    CHECK(raster::exp2(0.0f) == 1.0f);
    CHECK(raster::exp2(-0.0f) == 1.0f);
    CHECK(raster::exp2(128.0f) == kInf);
    CHECK(raster::exp2(std::nextafter(128.0f, 0.0f)) < kInf);
    CHECK(raster::exp2(-126.0f) == raster::kMinNormal);
    CHECK(bits_of(raster::exp2(std::nextafter(-126.0f, -kInf))) == 0);  // would be subnormal
    CHECK(raster::exp2(kInf) == kInf);
    CHECK(bits_of(raster::exp2(-kInf)) == 0);
    CHECK(raster::exp2(raster::kMaxFinite) == kInf);
    CHECK(std::isnan(raster::exp2(kNaN)));
}

// -------------------------------------------------------------------------------------------------------- exp

TEST_CASE("exp is within 0.991 ulp over the whole range and 0 or inf outside") {
    Worst worst;
    int wrong_outside = 0;
    for_every_257th_float([&](float x) {
        const float got = raster::exp(x);
        if (std::isnan(x))
            wrong_outside += !std::isnan(got);
        else if (x >= 88.72284f)
            wrong_outside += got != kInf;
        else if (x < -87.33654f)
            wrong_outside += bits_of(got) != 0;
        else
            worst.add(ulps(got, std::exp(static_cast<double>(x))), x);
    });
    CAPTURE(worst.at);
    CHECK(worst.count > 8'000'000);
    CHECK(worst.error <= 0.991);  // the stated bound; all floats were checked once: 0.9903
    CHECK(wrong_outside == 0);
}

TEST_CASE("exp special values lie where the true result leaves the normal numbers") {
    CHECK(raster::exp(0.0f) == 1.0f);
    CHECK(raster::exp(-0.0f) == 1.0f);
    CHECK(std::exp(static_cast<double>(88.72284f)) > raster::kMaxFinite);
    CHECK(raster::exp(88.72284f) == kInf);
    CHECK(raster::exp(std::nextafter(88.72284f, 0.0f)) < kInf);
    CHECK(std::exp(static_cast<double>(-87.33654f)) >= raster::kMinNormal);
    CHECK(raster::exp(-87.33654f) >= raster::kMinNormal);
    CHECK(std::exp(static_cast<double>(std::nextafter(-87.33654f, -kInf))) < raster::kMinNormal);
    CHECK(bits_of(raster::exp(std::nextafter(-87.33654f, -kInf))) == 0);
    CHECK(raster::exp(kInf) == kInf);
    CHECK(bits_of(raster::exp(-kInf)) == 0);
    CHECK(std::isnan(raster::exp(kNaN)));
}

// ------------------------------------------------------------------------------------------------------- log2

TEST_CASE("log2 is within 0.67 ulp over all normal numbers") {
    Worst worst;
    int wrong_outside = 0;
    for_every_257th_float([&](float x) {
        const float got = raster::log2(x);
        if (std::isnan(x))
            wrong_outside += !std::isnan(got);
        else if (x < raster::kMinNormal)
            wrong_outside += got != -kInf;
        else if (x == kInf || x == 1.0f)
            wrong_outside += got != (x == 1.0f ? 0.0f : kInf);
        else
            worst.add(ulps(got, std::log2(static_cast<double>(x))), x);
    });
    CAPTURE(worst.at);
    CHECK(worst.count > 8'000'000);
    CHECK(worst.error <= 0.67);  // the stated bound; all floats were checked once: 0.662
    CHECK(wrong_outside == 0);
}

TEST_CASE("log2 keeps its relative precision next to one") {
    for (int step = 1; step < 2000; ++step) {
        for (const float x : {1.0f + 0x1p-23f * static_cast<float>(step), 1.0f - 0x1p-24f * static_cast<float>(step)}) {
            CAPTURE(x);
            const double want = std::log2(static_cast<double>(x));
            CHECK(std::fabs(raster::log2_in_double(x) / want - 1.0) < 1.1e-8);  // the stated bound
        }
    }
}

TEST_CASE("log2 special values") {
    CHECK(raster::log2(1.0f) == 0.0f);
    CHECK(raster::log2(0.0f) == -kInf);
    CHECK(raster::log2(-0.0f) == -kInf);
    CHECK(raster::log2(-3.0f) == -kInf);
    CHECK(raster::log2(kSmallestSubnormal) == -kInf);
    CHECK(raster::log2(-kInf) == -kInf);
    CHECK(raster::log2(kInf) == kInf);
    CHECK(raster::log2(raster::kMaxFinite) == 128.0f);  // 128 - 8.6e-8, rounded
    CHECK(std::isnan(raster::log2(kNaN)));
}

// -------------------------------------------------------------------------------------------------------- pow

TEST_CASE("pow is within 1e-6 wherever the result lies in 1e-30 to 1e30") {
    std::vector<float> bases;
    for (int i = -400; i <= 400; ++i) bases.push_back(static_cast<float>(std::exp2(0.2497 * i)));  // 2^-100..2^100
    for (int i = 1; i <= 400; ++i) bases.push_back(static_cast<float>(i) / 400.0f * 1.5f);         // 0..1.5
    for (int i = 0; i < 96; ++i) bases.push_back(static_cast<float>(1.0 - std::exp2(-0.25 * i)));  // 1 from below
    for (int i = 0; i < 92; ++i) bases.push_back(static_cast<float>(1.0 + std::exp2(-0.25 * i)));  // 1 from above
    Worst worst;
    double worst_of_bound = 0.0;
    for (const float x : bases) {
        for (int i = 0; i <= 240; ++i) {
            const float size = static_cast<float>(std::pow(10.0, 0.05 * i - 6.0));  // 1e-6..1e6
            for (const float y : {size, -size}) {
                const long double want = powl(x, y);
                if (!(x > 0.0f && want >= 1e-30L && want <= 1e30L)) continue;
                const double error = static_cast<double>(std::fabs(raster::pow(x, y) / want - 1.0L));
                const double bound = 7.5e-9 * std::fabs(y * std::log2(static_cast<double>(x))) + 1.1e-7;
                worst.add(error, x);
                worst_of_bound = std::fmax(worst_of_bound, error / bound);
            }
        }
    }
    CAPTURE(worst.at);
    CHECK(worst.count > 300'000);
    CHECK(worst.error < 8.6e-7);   // the stated bound
    CHECK(worst_of_bound <= 1.0);  // the stated growth with |y log2 x|
}

TEST_CASE("pow of whole shininess exponents matches repeated multiplication") {
    for (const float n_dot_h : {0.3f, 0.7f, 0.9f, 0.99f, 0.999f, 0.9999f, 0.99999f, 1.0f}) {
        long double product = 1.0L;
        for (int shininess = 1; shininess <= 1000; ++shininess) {
            product *= n_dot_h;
            if (product < 1e-30L) break;
            CAPTURE(n_dot_h);
            CAPTURE(shininess);
            const float got = raster::pow(n_dot_h, static_cast<float>(shininess));
            CHECK(std::fabs(static_cast<double>(got / product - 1.0L)) < 8.6e-7);  // the stated bound
        }
    }
}

TEST_CASE("pow of powers of two with whole exponents is exact") {
    for (int k = -20; k <= 20; ++k) {
        for (int y = -6; y <= 6; ++y) {
            CAPTURE(k);
            CAPTURE(y);
            CHECK(raster::pow(std::ldexp(1.0f, k), static_cast<float>(y)) == std::ldexp(1.0f, k * y));
        }
    }
    CHECK(raster::pow(4.0f, 0.5f) == 2.0f);
    CHECK(raster::pow(0.25f, 1.5f) == 0.125f);
}

TEST_CASE("pow special values") {
    for (const float y : {kSmallestSubnormal, 1e-37f, 1e-7f, 0.5f, 1.0f, 2.0f, 1000.0f, 1e6f, raster::kMaxFinite}) {
        CAPTURE(y);
        for (const float zero : {0.0f, -0.0f, kSmallestSubnormal, -2.0f}) {  // all of these count as 0
            CHECK(bits_of(raster::pow(zero, y)) == 0);
            CHECK(raster::pow(zero, -y) == kInf);
        }
        CHECK(raster::pow(1.0f, y) == 1.0f);
        CHECK(raster::pow(1.0f, -y) == 1.0f);
        CHECK(raster::pow(kInf, y) == kInf);
        CHECK(bits_of(raster::pow(kInf, -y)) == 0);
        CHECK(std::isnan(raster::pow(kNaN, y)));
    }
    for (const float x : {0.0f, kSmallestSubnormal, 1e-37f, 0.3f, 1.0f, 7.0f, raster::kMaxFinite, kInf, kNaN}) {
        CAPTURE(x);
        CHECK(raster::pow(x, 0.0f) == 1.0f);
        CHECK(raster::pow(x, -0.0f) == 1.0f);
        CHECK(std::isnan(raster::pow(x, kNaN)));
    }
    CHECK(raster::pow(2.0f, raster::kMaxFinite) == kInf);
    CHECK(bits_of(raster::pow(0.5f, raster::kMaxFinite)) == 0);
    CHECK(bits_of(raster::pow(0.5f, 127.0f)) == 0);  // 2^-127 would be subnormal
    CHECK(raster::pow(0.5f, 126.0f) == raster::kMinNormal);
    for (std::uint32_t step = 1; step < 1000; ++step) {  // (2^-63 (1 - step 2^-24))^2: just below 2^-126
        CHECK(bits_of(raster::pow(std::bit_cast<float>(bits_of(0x1p-63f) - step), 2.0f)) == 0);
    }
}

TEST_CASE("a batch loop gives the bits of single calls") {
    std::vector<float> x;
    for (std::uint64_t bits = 0; bits < (std::uint64_t{1} << 32); bits += 65'521) {  // prime
        x.push_back(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    }
    const int n = static_cast<int>(x.size());
    std::vector<float> exp2_of(x.size()), exp_of(x.size()), log2_of(x.size()), pow_of(x.size());
    exp2_batch(x.data(), exp2_of.data(), n);
    exp_batch(x.data(), exp_of.data(), n);
    log2_batch(x.data(), log2_of.data(), n);
    pow_batch(x.data(), 2.2f, pow_of.data(), n);
    int differences = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const volatile float single = x[i];  // keeps the compiler from turning this loop into a batch, too
        if (std::isnan(single)) continue;    // the bits inside a NaN are not promised
        differences += bits_of(exp2_of[i]) != bits_of(raster::exp2(single));
        differences += bits_of(exp_of[i]) != bits_of(raster::exp(single));
        differences += bits_of(log2_of[i]) != bits_of(raster::log2(single));
        differences += bits_of(pow_of[i]) != bits_of(raster::pow(single, 2.2f));
    }
    CHECK(differences == 0);
}

// ---------------------------------------------------------------------------------------------------- helpers

TEST_CASE("The smaller of two positive numbers by their bits is the smaller by comparison") {
    int wrong = 0;
    for_every_257th_float([&](float x) {
        if (!(x >= 0.0f) || bits_of(x) == bits_of(-0.0f)) return;
        for (const float y : {0.0f, 1e-42f, 1e-20f, 0.99999994f, 1.0f, 3e38f, kInf}) {
            wrong += bits_of(raster::smaller_of_positive(x, y)) != bits_of(x < y ? x : y);
        }
    });
    CHECK(wrong == 0);
}

TEST_CASE("The smooth ramp goes from 0 to 1 through the middle and is flat at both ends") {
    CHECK(raster::smooth_ramp(0.0f) == 0.0f);
    CHECK(raster::smooth_ramp(0.25f) == 0.15625f);  // 3/16 - 2/64
    CHECK(raster::smooth_ramp(0.5f) == 0.5f);
    CHECK(raster::smooth_ramp(1.0f) == 1.0f);
    const float h = 1e-3f;  // the slope 6t (1 - t) is 6h there: what is left over is 3h^2
    CHECK(raster::smooth_ramp(h) < 3.1f * h * h);
    CHECK(1.0f - raster::smooth_ramp(1.0f - h) < 3.1f * h * h);
}

TEST_CASE("saturate clamps to 0..1 and maps NaN to 0") {
    int wrong = 0;
    for_every_257th_float([&](float x) {
        const float got = raster::saturate(x);
        const float want = x >= 1.0f ? 1.0f : (x > 0.0f ? x : 0.0f);
        wrong += bits_of(got) != bits_of(want);
        wrong += bits_of(raster::saturate(got)) != bits_of(got);
    });
    CHECK(wrong == 0);
    CHECK(bits_of(raster::saturate(kNaN)) == 0);
    CHECK(bits_of(raster::saturate(-kNaN)) == 0);
    CHECK(bits_of(raster::saturate(-0.0f)) == 0);
    CHECK(raster::saturate(kInf) == 1.0f);
    CHECK(raster::saturate(-kInf) == 0.0f);
}

TEST_CASE("lerp is exact at both ends and symmetric") {
    const std::vector<float> values = {0.0f, 1.0f, 1.0f / 3.0f, -7.3f, 1e8f, 1e-30f, 3e38f, -3e38f};
    for (const float a : values) {
        for (const float b : values) {
            CAPTURE(a);
            CAPTURE(b);
            CHECK(raster::lerp(a, b, 0.0f) == a);
            CHECK(raster::lerp(a, b, 1.0f) == b);  // a + t (b - a) gives 0 for a = 1e8 and b = 1
            CHECK(raster::lerp(a, b, 0.125f) == raster::lerp(b, a, 0.875f));
        }
    }
    CHECK(raster::lerp(2.0f, 6.0f, 0.25f) == 3.0f);
}

TEST_CASE("rounding half up is the floor of x plus one half") {
    CHECK(raster::round_half_up_to_int(2.5f) == 3);
    CHECK(raster::round_half_up_to_int(-2.5f) == -2);
    CHECK(raster::round_half_up_to_int(-0.5f) == 0);
    CHECK(raster::round_half_up_to_int(0.49999997f) == 0);       // floor(x + 0.5f) in float gives 1
    CHECK(raster::round_half_up_to_int(8388609.0f) == 8388609);  // floor(x + 0.5f) in float gives 8388610
    CHECK(raster::round_half_up_to_int(0x1.fffffep30f) == 2147483520);
    int wrong = 0;
    for_every_257th_float([&](float x) {
        if (!(std::fabs(x) < 2147483648.0f)) return;
        wrong += raster::round_half_up_to_int(x) != static_cast<std::int32_t>(std::floor(static_cast<double>(x) + 0.5));
    });
    for (int twice = -2001; twice <= 2001; ++twice) {
        const float x = 0.5f * static_cast<float>(twice);
        wrong += raster::round_half_up_to_int(x) != static_cast<std::int32_t>(std::floor(static_cast<double>(x) + 0.5));
    }
    CHECK(wrong == 0);
}

TEST_CASE("is_finite agrees with the standard library") {
    int wrong = 0;
    for_every_257th_float([&](float x) { wrong += raster::is_finite(x) != std::isfinite(x); });
    CHECK(wrong == 0);
    CHECK(raster::is_finite(raster::kMaxFinite));
    CHECK(!raster::is_finite(kInf));
    CHECK(!raster::is_finite(-kInf));
    CHECK(!raster::is_finite(kNaN));
}

TEST_CASE("pi and radians") {
    CHECK(raster::kPi == static_cast<float>(std::numbers::pi));
    CHECK(raster::kTwoPi == static_cast<float>(2.0 * std::numbers::pi));
    CHECK(raster::kInvPi == static_cast<float>(std::numbers::inv_pi));
    CHECK(raster::radians(0.0f) == 0.0f);
    for (int angle_deg = 1; angle_deg <= 720; ++angle_deg) {
        CAPTURE(angle_deg);
        // Half an ulp from the constant, which a product can double, and half an ulp from the product.
        CHECK(ulps(raster::radians(static_cast<float>(angle_deg)), angle_deg * std::numbers::pi / 180.0) <= 1.5);
    }
}
