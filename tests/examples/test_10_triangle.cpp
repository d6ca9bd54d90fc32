// Laws about the pictures of 10_triangle, from the golden images.
#include <array>

#include <doctest/doctest.h>

#include "course.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

/// Is (x, y) strictly inside the polygon of corners given in quarters of a pixel? By the crossing number of a ray to
/// the right, in exact integers, which uses no edge function. No centre lies on an edge of the example's triangle.
bool inside_by_ray(const std::array<std::array<int, 2>, 3>& corner, int x, int y) {
    const int p_x = 4 * x + 2, p_y = 4 * y + 2;
    bool inside = false;
    for (int i = 0; i < 3; ++i) {
        const auto& a = corner[i];
        const auto& b = corner[(i + 1) % 3];
        if ((a[1] > p_y) == (b[1] > p_y)) continue;
        const int rise = b[1] - a[1];
        const int left_of = (p_x - a[0]) * rise - (p_y - a[1]) * (b[0] - a[0]);
        if (rise > 0 ? left_of < 0 : left_of > 0) inside = !inside;
    }
    return inside;
}

/// Painted cells of the square's panel in top_left_rule.png, 0, 1 (blue) or 2 (red), summed.
std::array<int, 3> count_by_colour(int panel) {
    const raster::Image picture = golden_montage("10_triangle/top_left_rule", 3);
    const int panel_width = (320 - 8) / 3, cell = panel_width / 8;
    const int left = panel * (panel_width + 4) + (panel_width - 8 * cell) / 2;
    const int top = (180 - 8 * cell) / 2;
    std::array<int, 3> count{};
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) {
            // Upper right part of the cell: away from the dot, the borders and the diagonal, which enters it nowhere.
            const glm::vec3 color = picture.rgb(left + x * cell + cell - 3, top + y * cell + 3);
            ++count[color.x > 0.7f ? 2 : color.z > 0.35f ? 1 : 0];
        }
    }
    return count;
}

}  // namespace

TEST_CASE("10 triangle: the covered pixels are those whose centre a ray test finds inside") {
    const std::array<std::array<int, 2>, 3> corner = {{{5, 31}, {21, 3}, {58, 24}}};
    const raster::Image picture = golden("10_triangle/coverage.png");
    int covered = 0;
    for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 16; ++x) covered += inside_by_ray(corner, x, y) ? 1 : 0;
    }
    CHECK(covered == documented_number("10_triangle", "covered"));
    double area2 = 0.0;  // shoelace formula, in quarters of a pixel
    for (int i = 0; i < 3; ++i) {
        area2 += corner[i][0] * corner[(i + 1) % 3][1] - corner[(i + 1) % 3][0] * corner[i][1];
    }
    CHECK(area2 / 2 / 16 == documented_number("10_triangle", "area"));
    int seen = 0;
    const int cell = picture.width / 16;
    for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 16; ++x) {
            // A line or a letter may hide the looked-at spot of one cell, so a cell counts if most of it is blue.
            int blue = 0;
            for (int j = 2; j < cell; ++j) {
                for (int i = 2; i < cell; ++i) {
                    const glm::vec3 color = picture.rgb(x * cell + i, y * cell + j);
                    blue += color.z > 0.5f && color.z > 1.5f * color.x ? 1 : 0;
                }
            }
            const bool is_blue = blue > cell * cell / 3;
            CAPTURE(x);
            CAPTURE(y);
            CHECK(is_blue == inside_by_ray(corner, x, y));
            seen += is_blue ? 1 : 0;
        }
    }
    CHECK(seen == covered);
}

TEST_CASE("10 triangle: strict gaps and inclusive doubles but top-left draws the square of 25 pixels once") {
    // By hand: the square's corners are the centres of pixels 1 and 6. Strictly inside are 4 x 4 centres, 4 of them on
    // the diagonal; inclusive are 6 x 6, 6 of them on the diagonal, which both triangles draw; half-open are 5 x 5.
    CHECK(count_by_colour(0)[1] == 12);
    CHECK(count_by_colour(0)[2] == 0);
    CHECK(count_by_colour(1)[1] == 30);
    CHECK(count_by_colour(1)[2] == 6);
    CHECK(count_by_colour(2)[1] == 25);
    CHECK(count_by_colour(2)[2] == 0);
}
