// A1: which of your functions a row of numbers is for. There is nothing to change here.
#include "assignment.hpp"
#include "harness.hpp"

namespace {

Point point_of(const double* v) {
    return {static_cast<std::int32_t>(v[0]), static_cast<std::int32_t>(v[1])};
}

Triangle triangle_of(const double* v) {
    return {point_of(v), point_of(v + 2), point_of(v + 4)};
}

/// How often a pixel is drawn, and how often it was tested: only where a triangle's box holds it.
void count_covers(harness::Row& row, int x, int y, int width, int height) {
    int covered = 0, tested = 0;
    for (std::size_t i = 0; i < row.count("triangles", 6); ++i) {
        const Triangle t = triangle_of(row.numbers("triangles") + 6 * i);
        const Box box = pixel_box(t, width, height);
        if (x < box.x_first || x > box.x_last || y < box.y_first || y > box.y_last) continue;
        ++tested;
        covered += covers(t, x, y) ? 1 : 0;
    }
    row.put("color", covered < 4 ? 0.25 * covered : 1.0);
    row.put("tested", tested);
}

}  // namespace

void run_row(harness::Row row) {
    if (row.is("edge_function")) {
        row.put("E", static_cast<double>(edge_function(point_of(row.numbers("a")), point_of(row.numbers("b")),
                                                       point_of(row.numbers("p")))));
    } else if (row.is("is_top_left")) {
        row.put("top_left", is_top_left(point_of(row.numbers("a")), point_of(row.numbers("b"))));
    } else if (row.is("covers")) {
        row.put("covered", covers(triangle_of(row.numbers("a_b_c")), static_cast<int>(row.integer("x")),
                                  static_cast<int>(row.integer("y"))));
    } else if (row.is("pixel_box")) {
        const Box box = pixel_box(triangle_of(row.numbers("a_b_c")), static_cast<int>(row.integer("width")),
                                  static_cast<int>(row.integer("height")));
        row.put("first_last", {double(box.x_first), double(box.y_first), double(box.x_last), double(box.y_last)});
    } else if (row.is("count_covers")) {
        count_covers(row, static_cast<int>(row.integer("x")), static_cast<int>(row.integer("y")),
                     static_cast<int>(row.integer("width")), static_cast<int>(row.integer("height")));
    }
}
