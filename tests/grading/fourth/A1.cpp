// A1, solved by another hand: steps between points, one test for each side, floor by hand.
#include "assignment.hpp"

namespace {

struct Step {
    std::int64_t right, down;
};

Step way(const Point& from, const Point& to) {
    return {std::int64_t(to.x) - from.x, std::int64_t(to.y) - from.y};
}

bool on_the_right_side(const Point& from, const Point& to, const Point& p) {
    const std::int64_t side = edge_function(from, to, p);
    if (side == 0) return is_top_left(from, to);
    return side > 0;
}

int pixel_of(std::int32_t place) {
    return place >= 0 ? place / 256 : -((255 - place) / 256);
}

}  // namespace

std::int64_t edge_function(const Point& a, const Point& b, const Point& p) {
    const Step along = way(a, b);
    const Step away = way(a, p);
    return along.right * away.down - along.down * away.right;
}

bool is_top_left(const Point& a, const Point& b) {
    if (a.y == b.y) return a.x < b.x;
    return a.y > b.y;
}

bool covers(const Triangle& t, int x, int y) {
    const Point middle{(x << 8) + 128, (y << 8) + 128};
    const Point corner[3] = {t.a, t.b, t.c};
    for (int i = 0; i < 3; ++i) {
        if (!on_the_right_side(corner[i], corner[(i + 1) % 3], middle)) return false;
    }
    return true;
}

Box pixel_box(const Triangle& t, int width, int height) {
    Point low = t.a, high = t.a;
    for (const Point& p : {t.b, t.c}) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    Box box;
    box.x_first = std::max(pixel_of(low.x), 0);
    box.y_first = std::max(pixel_of(low.y), 0);
    box.x_last = std::min(pixel_of(high.x), width - 1);
    box.y_last = std::min(pixel_of(high.y), height - 1);
    return box;
}
