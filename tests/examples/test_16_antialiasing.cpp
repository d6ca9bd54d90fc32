// The star of 16_antialiasing against the true area of its spokes in every pixel.
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "course.hpp"
#include "raster/film.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

constexpr int kPixels = 52;
constexpr int kFine = 64;  // brute force: 64 x 64 points a pixel, good to about 1/128 of a pixel's area

/// Is a point of the star's plane inside a spoke? A spoke is a triangle: a wedge, cut off by its chord.
bool in_star(double x, double y) {
    const double step = 2 * 3.14159265358979 / 18;
    double turn = std::atan2(y, x) / step;
    turn -= std::floor(turn);
    if (turn < 0.15 || turn > 0.65) return false;
    return std::hypot(x, y) * std::cos((turn - 0.4) * step) < std::cos(0.25 * step);
}

double true_coverage(int px, int py) {
    int inside = 0;
    for (int j = 0; j < kFine; ++j) {
        for (int i = 0; i < kFine; ++i) {
            const double x = ((px + (i + 0.5) / kFine) / kPixels - 0.5) * 2.1;
            const double y = (0.5 - (py + (j + 0.5) / kFine) / kPixels) * 2.1;
            inside += in_star(x, y) ? 1 : 0;
        }
    }
    return double(inside) / (kFine * kFine);
}

/// Coverage that a pixel of a panel shows: from the board's to chalk's linear light.
double shown_coverage(const raster::Image& picture, int panel, int px, int py) {
    const int width = (320 - 8) / 3, factor = width / kPixels;
    const int left = panel * (width + 4) + (width - factor * kPixels) / 2, top = (180 - factor * kPixels) / 2;
    const float board = raster::linear_from_srgb(0x26 / 255.0f), chalk = raster::linear_from_srgb(0xee / 255.0f);
    const float seen = raster::linear_from_srgb(picture.at(1, left + px * factor, top + py * factor));
    return (seen - board) / (chalk - board);
}

struct Errors {
    double largest = 0, mean = 0;
};

Errors errors_of(int panel) {
    const raster::Image picture = golden_montage("16_antialiasing/star", 3);
    Errors errors;
    int count = 0;
    for (int y = 0; y < kPixels; ++y) {
        for (int x = 0; x < kPixels; ++x) {
            const double radius = std::hypot(x + 0.5 - 26, y + 0.5 - 26);
            if (radius < 12 || radius > 23) continue;  // pixels that are crossed by one straight edge at most
            const double error = std::abs(shown_coverage(picture, panel, x, y) - true_coverage(x, y));
            errors.largest = std::max(errors.largest, error);
            errors.mean += error;
            ++count;
        }
    }
    errors.mean /= count;
    return errors;
}

}  // namespace

TEST_CASE("16 antialiasing: with n x n samples an edge pixel is right within 1 in 2n and better on the mean") {
    const double fine = 0.01;  // the brute force's own error and one step of 1/255 in the dark
    const Errors one = errors_of(0), four = errors_of(1), sixteen = errors_of(2);
    CHECK(one.largest <= 0.5 + fine);
    CHECK(four.largest <= 0.25 + fine);
    CHECK(sixteen.largest <= documented_number("16_antialiasing", "bound") + fine);
    CHECK(four.mean < 0.5 * one.mean);
    CHECK(sixteen.mean < 0.5 * four.mean);
    CHECK(sixteen.mean < 1.0 / 16);
}
