// A1, solved by another hand: functions of pixels, ranges along an axis.
#include "assignment.hpp"

namespace {

/// Twice the area that the corners (x, y) of a, b and p span.
std::int64_t twice_area(const Point& a, const Point& b, const Point& p) {
    const std::int64_t left_product = std::int64_t(a.x - p.x) * (b.y - p.y);
    const std::int64_t right_product = std::int64_t(a.y - p.y) * (b.x - p.x);
    return left_product - right_product;
}

Point centre_of(int column, int row) {
    const int half = 256 / 2;
    return Point{column * 256 + half, row * 256 + half};
}

bool owns(const Point& a, const Point& b, std::int64_t e) {
    if (e == 0) return is_top_left(a, b);
    return e > 0;
}

struct Range {
    int first, last;
};

Range range_of(int a, int b, int c, int count) {
    int low = a < b ? a : b, high = a < b ? b : a;
    if (c < low) low = c;
    if (c > high) high = c;
    Range r{low >> 8, high >> 8};
    if (r.first < 0) r.first = 0;
    if (r.last > count - 1) r.last = count - 1;
    return r;
}

}  // namespace

std::int64_t edge_function(const Point& a, const Point& b, const Point& p) {
    return twice_area(a, b, p);
}

bool is_top_left(const Point& a, const Point& b) {
    if (a.y == b.y) return a.x < b.x;
    return a.y > b.y;
}

bool covers(const Triangle& t, int x, int y) {
    const Point p = centre_of(x, y);
    if (!owns(t.a, t.b, edge_function(t.a, t.b, p))) return false;
    if (!owns(t.b, t.c, edge_function(t.b, t.c, p))) return false;
    return owns(t.c, t.a, edge_function(t.c, t.a, p));
}

Box pixel_box(const Triangle& t, int width, int height) {
    const Range columns = range_of(t.a.x, t.b.x, t.c.x, width);
    const Range rows = range_of(t.a.y, t.b.y, t.c.y, height);
    return Box{columns.first, rows.first, columns.last, rows.last};
}
