// Laws about the pictures of 11_z_buffer: who is in front, and how deep, by planes through three points in double.
#include <algorithm>
#include <array>
#include <cmath>

#include <doctest/doctest.h>

#include "course.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

using Point = std::array<double, 3>;
using Corners = std::array<Point, 3>;
constexpr Corners kOrangeCorners = {{{-0.8, 0.85, -0.7}, {0.85, 0.1, 0.7}, {-0.65, -0.65, -0.7}}};
constexpr Corners kBlueCorners = {{{0.75, -0.7, -0.9}, {-0.85, -0.1, 0.8}, {0.65, 0.9, -0.3}}};

double area(double ax, double ay, double bx, double by, double cx, double cy) {
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
}

/// Depth 0..1 at (x, y), and how far inside the triangle (x, y) is: the least barycentric coordinate.
struct Hit {
    double z, inside;
};
Hit hit(const Corners& t, double x, double y) {
    const double whole = area(t[0][0], t[0][1], t[1][0], t[1][1], t[2][0], t[2][1]);
    Hit h{0.0, 1.0};
    for (int i = 0; i < 3; ++i) {
        const Point &b = t[(i + 1) % 3], &c = t[(i + 2) % 3];
        const double lambda = area(x, y, b[0], b[1], c[0], c[1]) / whole;
        h.z += lambda * t[i][2];
        h.inside = std::min(h.inside, lambda);
    }
    h.z = 0.5 * h.z + 0.5;
    return h;
}

double encoded(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

}  // namespace

TEST_CASE("11 z-buffer: at every pixel the triangle with the smaller depth is seen and its depth is kept") {
    const raster::Image picture = golden("11_z_buffer/z_buffer.png");
    const raster::Image depth = golden("11_z_buffer/depth.png");
    int both = 0;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const double ndc_x = (x + 0.5) / picture.width * 2 - 1, ndc_y = 1 - (y + 0.5) / picture.height * 2;
            const Hit orange = hit(kOrangeCorners, ndc_x, ndc_y), blue = hit(kBlueCorners, ndc_x, ndc_y);
            // Corners are rounded to 1/256 pixel: leave out what lies within about a pixel of an edge or the crossing.
            if (std::abs(orange.inside) < 0.01 || std::abs(blue.inside) < 0.01) continue;
            const bool in_orange = orange.inside > 0, in_blue = blue.inside > 0;
            if (in_orange && in_blue && std::abs(orange.z - blue.z) < 0.005) continue;
            both += in_orange && in_blue ? 1 : 0;
            const bool orange_wins = in_orange && (!in_blue || orange.z < blue.z);
            CAPTURE(x);
            CAPTURE(y);
            if (in_orange || in_blue) {
                const glm::vec3 color = picture.rgb(x, y);
                CHECK((color.x > color.z) == orange_wins);
            }
            const double z = orange_wins ? orange.z : in_blue ? blue.z : 1.0;
            // Half a step of 1/255 for the byte, the rest for the snap to 1/256 pixel.
            CHECK(std::abs(depth.at(0, x, y) - encoded(z)) < 0.6 / 255);
        }
    }
    CHECK(both > 3000);
}

TEST_CASE("11 z-buffer: the depths in the middle are those on the page") {
    const double half_step = 0.00051;  // three decimals
    CHECK(std::abs(hit(kOrangeCorners, 0, 0).z - documented_number("11_z_buffer", "orange")) < half_step);
    CHECK(std::abs(hit(kBlueCorners, 0, 0).z - documented_number("11_z_buffer", "blue")) < half_step);
}
