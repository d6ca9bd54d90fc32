// A1, solved by another hand: a loop over the corners, early returns, plain C.
#include "assignment.hpp"

std::int64_t edge_function(const Point& a, const Point& b, const Point& p) {
    const long long dx = b.x - a.x;
    const long long dy = b.y - a.y;
    const long long left = dx * (p.y - a.y);
    const long long right = dy * (p.x - a.x);
    return left - right;
}

bool is_top_left(const Point& a, const Point& b) {
    if (a.y == b.y) return a.x < b.x;
    return a.y > b.y;
}

bool covers(const Triangle& t, int x, int y) {
    const Point corner[4] = {t.a, t.b, t.c, t.a};
    Point p;
    p.x = (x << 8) + 128;
    p.y = (y << 8) + 128;
    for (int i = 0; i < 3; i++) {
        const std::int64_t e = edge_function(corner[i], corner[i + 1], p);
        if (e < 0) return false;
        if (e == 0 && !is_top_left(corner[i], corner[i + 1])) return false;
    }
    return true;
}

Box pixel_box(const Triangle& t, int width, int height) {
    int left = t.a.x, right = t.a.x, top = t.a.y, bottom = t.a.y;
    for (const Point& q : {t.b, t.c}) {
        if (q.x < left) left = q.x;
        if (q.x > right) right = q.x;
        if (q.y < top) top = q.y;
        if (q.y > bottom) bottom = q.y;
    }
    Box box{left >> 8, top >> 8, right >> 8, bottom >> 8};
    if (box.x_first < 0) box.x_first = 0;
    if (box.y_first < 0) box.y_first = 0;
    if (box.x_last >= width) box.x_last = width - 1;
    if (box.y_last >= height) box.y_last = height - 1;
    return box;
}
