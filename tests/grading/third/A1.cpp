// A1 by a third hand: a loop over the sides, a helper for the cross product, a box that grows corner by corner.
#include "assignment.hpp"

namespace {

struct Side {
    Point start, end;
};

long long cross(long long ux, long long uy, long long vx, long long vy) {
    return ux * vy - uy * vx;
}

/// Whole pixels to the left of (or above) a place.
int pixel_of(std::int32_t place) {
    return place >= 0 ? place / 256 : -((255 - place) / 256);
}

}  // namespace

std::int64_t edge_function(const Point& a, const Point& b, const Point& p) {
    return cross(b.x - a.x, b.y - a.y, p.x - a.x, p.y - a.y);
}

bool is_top_left(const Point& a, const Point& b) {
    const int rise = b.y - a.y;
    if (rise < 0) return true;
    if (rise > 0) return false;
    return b.x > a.x;
}

bool covers(const Triangle& t, int x, int y) {
    Point middle;
    middle.x = 256 * x + 128;
    middle.y = 256 * y + 128;
    const Side sides[] = {{t.a, t.b}, {t.b, t.c}, {t.c, t.a}};
    for (const Side& side : sides) {
        const std::int64_t e = edge_function(side.start, side.end, middle);
        if (e > 0) continue;
        if (e < 0) return false;
        if (!is_top_left(side.start, side.end)) return false;
    }
    return true;
}

Box pixel_box(const Triangle& t, int width, int height) {
    Box box{pixel_of(t.a.x), pixel_of(t.a.y), pixel_of(t.a.x), pixel_of(t.a.y)};
    for (const Point& corner : {t.b, t.c}) {
        const int column = pixel_of(corner.x), row = pixel_of(corner.y);
        if (column < box.x_first) box.x_first = column;
        if (column > box.x_last) box.x_last = column;
        if (row < box.y_first) box.y_first = row;
        if (row > box.y_last) box.y_last = row;
    }
    if (box.x_first < 0) box.x_first = 0;
    if (box.y_first < 0) box.y_first = 0;
    if (box.x_last >= width) box.x_last = width - 1;
    if (box.y_last >= height) box.y_last = height - 1;
    return box;
}
