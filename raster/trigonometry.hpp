// Angles without the C library: the same bits with every compiler, on every machine (see raster/scalar_math.hpp).
// The float functions run inside batch loops; the double ones serve tables that are made once.
#pragma once

#include <cmath>

#include "raster/scalar_math.hpp"

namespace kreda::raster {

/// Sine and cosine of one angle.
struct SinCos {
    float sin, cos;  ///< in [-1, 1]
};

/// sin and cos of an angle counted in whole turns: 0.25 is 90 degrees.   |turns| < 2^20.
/// Method: the nearest quarter turn is taken off, which is exact; polynomials on [-pi/4, pi/4] (Moshier, Cephes 1989).
/// Absolute error, every float of [-1, 1] checked: at most 1.1e-7. Quarter turns are exact.
inline SinCos sin_cos_of_turns(float turns) {
    const IntegerFraction quarter = split_fraction(4.0f * turns);
    const float x = quarter.fraction * (0.25f * kTwoPi);
    const float x2 = x * x;
    const float s = x + x * x2 * ((-1.9515295891e-4f * x2 + 8.3321608736e-3f) * x2 - 1.6666654611e-1f);
    const float c = (1.0f - 0.5f * x2) +
                    x2 * x2 * ((2.443315711809948e-5f * x2 - 1.388731625493765e-3f) * x2 + 4.166664568298827e-2f);
    const bool odd = (quarter.integer_bits & 1u) != 0u;
    const float sine = odd ? c : s;
    const float cosine = odd ? s : c;
    const bool sine_negative = (quarter.integer_bits & 2u) != 0u;
    const bool cosine_negative = ((quarter.integer_bits + 1u) & 2u) != 0u;
    return {sine_negative ? -sine : sine, cosine_negative ? -cosine : cosine};
}

/// The angle of the point (x, y), counted in turns, in [-1/2, 1/2]. (0, 0) gives 0. x and y finite.
/// Method: the octant |y| <= |x| by exchanging them, then atan(t) on [0, 1] = pi/4 + atan((t - 1)/(t + 1)) above
/// tan(pi/8), and a polynomial (Moshier, Cephes 1989). Error, 10^7 points: at most 6.0e-8 turns (3.8e-7 rad).
inline float atan2_in_turns(float y, float x) {
    const float abs_x = x < 0.0f ? -x : x;
    const float abs_y = y < 0.0f ? -y : y;
    const bool steep = abs_y > abs_x;
    const float larger = steep ? abs_y : abs_x;
    const float smaller = steep ? abs_x : abs_y;
    const float t = smaller / (larger > kMinNormal ? larger : kMinNormal);
    const bool upper = t > 0.41421357f;  // tan(pi/8)
    const float z = upper ? (t - 1.0f) / (t + 1.0f) : t;
    const float z2 = z * z;
    const float p = ((8.05374449538e-2f * z2 - 1.38776856032e-1f) * z2 + 1.99777106478e-1f) * z2 - 3.33329491539e-1f;
    const float octant = (upper ? 0.125f : 0.0f) + (z + z * z2 * p) * (0.5f * kInvPi);
    const float quadrant = steep ? 0.25f - octant : octant;
    const float half = x < 0.0f ? 0.5f - quadrant : quadrant;
    return y < 0.0f ? -half : half;
}

/// atan x in double   = 4 atan(x / 4-th of the angle), halved twice by  atan x = 2 atan(x / (1 + sqrt(1 + x^2))),  then
/// Taylor's series. For |x| <= 1; error 4e-16.
inline double atan_in_double(double x) {
    const double half = x / (1.0 + std::sqrt(1.0 + x * x));
    const double quarter = half / (1.0 + std::sqrt(1.0 + half * half));
    const double q2 = quarter * quarter;  // at most 0.0396
    double sum = 0.0;
    for (int k = 21; k >= 1; k -= 2) sum = 1.0 / k - q2 * sum;
    return 4.0 * quarter * sum;
}

/// cos of an angle counted in turns, in double, for turns in [0, 1/2]; error 2e-16.
/// Taylor's series of the sine of the distance to a quarter turn, or of the cosine near the ends.
inline double cos_of_turns_in_double(double turns) {
    constexpr double kTwoPiDouble = 6.283185307179586476925;
    const double from_quarter = kTwoPiDouble * (0.25 - turns);
    const double from_end = kTwoPiDouble * (turns < 0.25 ? turns : 0.5 - turns);
    const bool near_end = from_end < 0.25 * kTwoPiDouble * 0.5;
    const double x = near_end ? from_end : from_quarter;
    const double x2 = x * x;
    double sum = 1.0;
    for (int k = near_end ? 20 : 21; k >= 2; k -= 2) sum = 1.0 - x2 * sum / (k * (k - 1));
    if (!near_end) return x * sum;
    return turns < 0.25 ? sum : -sum;
}

}  // namespace kreda::raster
