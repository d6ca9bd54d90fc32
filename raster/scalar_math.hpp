// Scalar maths for per-pixel formulas: exp2, log2, exp, pow and helpers that the compiler can run 4 to 16 lanes wide.
//
// Why not std::pow? A libm call inside a loop stops the vectorizer, and each libm rounds in its own way, so the same
// scene would give other pixels on another machine. Here there are only + - * /, comparisons, selects and bit casts:
// IEEE fixes each of them, so the bits are the same at -O0 and -O3, with any instruction set, with GCC and Clang
// (given -ffp-contract=off, no -ffast-math, round-to-nearest).
//
// Two rules hold for the whole file:
// * subnormal numbers count as 0, coming in and going out (a CPU may take 100 cycles for one, and some flush them);
// * NaN in, NaN out, unless a function says otherwise.
// From another namespace write raster::exp2(x): a bare exp2(x) may find the one of the C library and still compile.
//
// The polynomials are minimax fits of the relative error (Lawson 1961, in 113-bit arithmetic), whose coefficients were
// then rounded one after another, each time fitting the remaining ones again.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace kreda::raster {

/// π, the float nearest to it.
inline constexpr float kPi = 3.14159265358979323846f;
/// 2 π
inline constexpr float kTwoPi = 6.28318530717958647693f;
inline constexpr float kInvPi = 0.31830988618379067154f;                ///< 1 / pi
inline constexpr float kMinNormal = std::numeric_limits<float>::min();  ///< 2^-126, the smallest normal number
inline constexpr float kMaxFinite = std::numeric_limits<float>::max();  ///< just below 2^128
/// +infinity
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// About how many operations exp() and pow() take: for estimates of what a scene costs.
inline constexpr double kExpOperations = 25.0;
/// The same of pow().
inline constexpr double kPowOperations = 60.0;

// ---------------------------------------------------------------------------------------------------- helpers

/// Angle in radians of an angle in degrees. At most 1.5 ulp from the exact product.
inline float radians(float angle_deg) {
    return angle_deg * 0.01745329251994329577f;
}

/// The smaller of two numbers that are not negative   a < b ? a : b
/// For speed it compares their bits: the exponent stands above the mantissa, so floats that are not negative have the
/// order of their bits read as integers, and the smaller of two integers is one vector instruction where a choice
/// between floats takes two. Infinity is the greatest number.
inline float smaller_of_positive(float a, float b) {
    const std::int32_t bits_a = std::bit_cast<std::int32_t>(a);
    const std::int32_t bits_b = std::bit_cast<std::int32_t>(b);
    return std::bit_cast<float>(bits_a < bits_b ? bits_a : bits_b);
}

/// x clamped to [0, 1]. NaN and -0 become +0: a spoiled pixel turns black instead of spoiling its neighbours.
inline float saturate(float x) {
    const float at_least_0 = x > 0.0f ? x : 0.0f;
    return smaller_of_positive(at_least_0, 1.0f);  // at_least_0 < 1 ? at_least_0 : 1
}

/// From 0 to 1 without a kink at either end   3t^2 - 2t^3,   t in [0, 1]
inline float smooth_ramp(float t) {
    return t * t * (3.0f - 2.0f * t);
}

/// Linear interpolation   (1 - t) a + t b     Exact at both ends (the form a + t (b - a) may miss b).
/// Finite a and b only: 0 * inf is NaN. Between the ends each of the four operations rounds once.
inline float lerp(float a, float b, float t) {
    return (1.0f - t) * a + t * b;
}

/// floor(x + 1/2) as an integer, without the rounding error of that sum: 2.5 -> 3, -2.5 -> -2, 0.49999997 -> 0.
/// Requires |x| < 2^31.
inline std::int32_t round_half_up_to_int(float x) {
    const std::int32_t truncated = static_cast<std::int32_t>(x);  // towards 0
    const float fraction = x - static_cast<float>(truncated);     // exact, in (-1, 1), the sign of x
    return truncated + (fraction >= 0.5f) - (fraction < -0.5f);
}

/// True unless x is NaN or an infinity: those two have all eight exponent bits set.
inline bool is_finite(float x) {
    return (std::bit_cast<std::uint32_t>(x) & 0x7f800000u) != 0x7f800000u;
}

// --------------------------------------------------------------------------------------- the bits of a float

/// x = mantissa * 2^exponent for a positive normal x.
struct MantissaExponent {
    float mantissa;         ///< in [sqrt(1/2), sqrt(2)): 1 lies inside, so log2(mantissa) is small near x = 1
    std::int32_t exponent;  ///< any power of 2 that a float has
};

/// Mantissa near 1 and exponent of a positive float.
inline MantissaExponent split_mantissa(float x) {
    constexpr std::uint32_t kSqrtHalfBits = 0x3f3504f3u;  // 0.70710677f
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(x);
    const std::int32_t exponent = static_cast<std::int32_t>(bits - kSqrtHalfBits) >> 23;
    const std::uint32_t shifted = static_cast<std::uint32_t>(exponent) << 23;
    return {std::bit_cast<float>(bits - shifted), exponent};
}

/// x = integer + fraction, integer the nearest one. For |x| < 2^22.
struct IntegerFraction {
    float integer;               ///< a whole number
    float fraction;              ///< in [-1/2, 1/2], exact
    std::uint32_t integer_bits;  ///< the integer in two's complement
};

/// Adding 1.5 * 2^23 pushes the fraction out of the mantissa (rounding to nearest) and leaves the integer in its low
/// bits. No conversion to int: that would be undefined for the NaN and the huge x that the callers select away later.
inline IntegerFraction split_fraction(float x) {
    constexpr float kMagic = 12582912.0f;  // 1.5 * 2^23
    const float pushed = x + kMagic;
    const float integer = pushed - kMagic;
    const std::uint32_t integer_bits = std::bit_cast<std::uint32_t>(pushed) - std::bit_cast<std::uint32_t>(kMagic);
    return {integer, x - integer, integer_bits};
}

/// p * 2^n by adding n to the exponent bits. The result must be a normal number.
inline float scale_by_power_of_two(float p, std::uint32_t n) {
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(p) + (n << 23));
}

// ----------------------------------------------------------------------------------------------- exponentials

/// 2^f for f in [-1/2, 1/2]   = 1 + (f/2 + f P(f)), degree 6.     Relative error of the fit 2.2e-9; exactly 1 at f = 0.
/// f/2 is exact and the larger part of f ln 2: it keeps the sum monotone in spite of the rounding of f P(f).
inline float exp2_of_fraction(float f) {
    float p = 0.00015342074f;
    p = p * f + 0.00133968994f;
    p = p * f + 0.00961847045f;
    p = p * f + 0.0555033945f;
    p = p * f + 0.240226477f;
    p = p * f + 0.193147197f;  // ln 2 - 1/2
    return 1.0f + (0.5f * f + f * p);
}

/// 2^(x + x_low), where x_low is what the rounding of a longer exponent to the float x left over (see pow).
inline float exp2_of_sum(float x, float x_low) {
    const IntegerFraction split = split_fraction(x);
    const float p = exp2_of_fraction(split.fraction + x_low);
    const float normal = scale_by_power_of_two(p, split.integer_bits);
    const float above_underflow = (x + 126.0f) + x_low;  // x = -126 with x_low < 0 is below 2^-126
    const float result = above_underflow >= 0.0f ? normal : 0.0f;
    return x < 128.0f ? result : x + kInfinity;  // NaN + inf is NaN
}

/// 2^x     Method: 2^x = 2^n 2^f, n the nearest integer, f = x - n (exact), 2^f by a polynomial, 2^n by exponent bits.
/// Error, every float checked: at most 0.83 ulp. Integers are exact; never decreasing.
/// x >= 128 -> inf; x < -126 -> 0 (the result would be subnormal); NaN -> NaN.
inline float exp2(float x) {
    return exp2_of_sum(x, 0.0f);
}

/// e^x     Method (Cody and Waite 1980): n = round(x / ln 2), r = x - n ln 2, e^x = 2^n e^r. ln 2 is the sum of a short
/// number, so that n * kLn2High is exact, and a small rest. e^r = 1 + r + r^2 P(r), degree 6, fit error 3.1e-9.
/// Error, every float checked: at most 0.991 ulp. exp(0) = 1; never decreasing.
/// x >= 88.72284 -> inf; x < -87.33654 -> 0 (the result would be subnormal); NaN -> NaN.
inline float exp(float x) {
    constexpr float kLog2E = 1.44269504f;
    constexpr float kLn2High = 0.693359375f;  // 355 / 512: 9 bits
    constexpr float kLn2Low = -2.12194440e-4f;
    const IntegerFraction split = split_fraction(x * kLog2E);
    const float r = (x - split.integer * kLn2High) - split.integer * kLn2Low;
    float p = 0.00138210109f;
    p = p * r + 0.0083686728f;
    p = p * r + 0.0416682623f;
    p = p * r + 0.166665211f;
    p = p * r + 0.49999994f;
    const float e_to_r = 1.0f + (r + r * r * p);
    const float normal = scale_by_power_of_two(e_to_r, split.integer_bits);
    const float result = x >= -87.33654f ? normal : 0.0f;
    return x < 88.72284f ? result : x + kInfinity;
}

// ---------------------------------------------------------------------------------------- logarithm and power

/// log2 x in double.
/// Method: x = 2^e m; t = m - 1 (exact) in [-0.293, 0.414]; log2 x = e + t (c1 + t (c2 + t P(t))), degree 10.
/// The form t(...) keeps the *relative* error small near x = 1, which pow with a large exponent needs. P runs in
/// float (twice the lanes), its rounding is damped by t^2; its terms are paired (Estrin 1960) to shorten the chain of
/// waiting operations. Relative error at most 1.1e-8 (every float from 0.35 to 2.9 checked); exact for powers of two.
/// x < 2^-126 (so 0, too, and negative x) -> -inf; inf -> inf; NaN -> NaN: these travel in the exponent.
inline double log2_in_double(float x) {
    const MantissaExponent split = split_mantissa(x);
    const float finite_exponent = static_cast<float>(split.exponent);
    const float upper_exponent = x <= kMaxFinite ? finite_exponent : x;  // inf or NaN
    const float exponent = x < kMinNormal ? -kInfinity : upper_exponent;

    const float t = split.mantissa - 1.0f;
    const float t2 = t * t;
    const float p01 = 0.480898231f - 0.360696644f * t;
    const float p23 = 0.28856793f - 0.239617974f * t;
    const float p45 = 0.204592153f - 0.191050202f * t;
    const float p67 = 0.186218396f - 0.110028453f * t;
    const float p = (p01 + p23 * t2) + (p45 + p67 * t2) * (t2 * t2);

    const double t_wide = t;
    const double q = 1.4426950408300439 + t_wide * (-0.72134735146357776 + t_wide * p);
    return exponent + t_wide * q;
}

/// log2 x     Method: log2_in_double, rounded once to float.
/// Error, every float checked: at most 0.67 ulp. Powers of two are exact; never decreasing.
/// x < 2^-126 (so 0, too, and negative x, unlike std::log2) -> -inf; inf -> inf; NaN -> NaN.
inline float log2(float x) {
    return static_cast<float>(log2_in_double(x));
}

/// A number as the sum of two floats: high is the nearest float, low what is left.
struct TwoFloats {
    float high, low;  ///< the number is their exact sum
};

/// The first half of pow: log2(x^y) = y log2 x. In double, because its error (of up to 100 and more) becomes a relative
/// error of the result; then as two floats, for twice the lanes.
inline TwoFloats log2_of_pow(float x, float y) {
    const double exponent = y * log2_in_double(x);
    const float high = static_cast<float>(exponent);
    return {high, static_cast<float>(exponent - high)};
}

/// The second half of pow: x^y from log2(x^y).
inline float pow_from_log2(TwoFloats log2_of_result, float y) {
    const float result = exp2_of_sum(log2_of_result.high, log2_of_result.low);
    return y == 0.0f ? 1.0f : result;
}

/// x^y for x >= 0, y finite     Method: x^y = 2^(y log2 x).
/// Relative error at most 7.5e-9 |y log2 x| + 1.1e-7, so 8.6e-7 for results in [1e-30, 1e30] (worst of
/// 10^8 pairs: 7.4e-7) and 1.9e-7 in [1e-3, 1e3].
/// x^0 = 1 for every x; 1^y = 1; 2^n exact for a power of two x and integer y; for x < 2^-126 (0, negative x): 0 if
/// y > 0, inf if y < 0; inf^y = inf if y > 0, 0 if y < 0; results below 2^-126 are 0; NaN in x or y -> NaN (not NaN^0).
inline float pow(float x, float y) {
    return pow_from_log2(log2_of_pow(x, y), y);
}

}  // namespace kreda::raster
