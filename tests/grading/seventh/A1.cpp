// A1, by one who goes round the corners in a loop and leaves as soon as the answer is known.
#include "assignment.hpp"

namespace {

struct Way {
    std::int64_t x, y;
};

Way way(const Point& from, const Point& to) {
    return {std::int64_t(to.x) - from.x, std::int64_t(to.y) - from.y};
}

int pixel_of(std::int32_t place) {
    int pixel = place / 256;
    if (place % 256 < 0) pixel--;
    return pixel;
}

}  // namespace

std::int64_t edge_function(const Point& a, const Point& b, const Point& p) {
    const Way side = way(a, b);
    const Way arm = way(a, p);
    return arm.y * side.x - arm.x * side.y;
}

bool is_top_left(const Point& a, const Point& b) {
    if (a.y == b.y) return a.x < b.x;
    return a.y > b.y;
}

bool covers(const Triangle& t, int x, int y) {
    const Point corner[3] = {t.a, t.b, t.c};
    Point middle;
    middle.x = 256 * x + 128;
    middle.y = 256 * y + 128;
    for (int i = 0; i < 3; i++) {
        const Point& from = corner[i];
        const Point& to = corner[(i + 1) % 3];
        const std::int64_t e = edge_function(from, to, middle);
        if (e < 0) return false;
        if (e == 0 && !is_top_left(from, to)) return false;
    }
    return true;
}

Box pixel_box(const Triangle& t, int width, int height) {
    Point low = t.a, high = t.a;
    for (const Point& corner : {t.b, t.c}) {
        low.x = std::min(low.x, corner.x);
        low.y = std::min(low.y, corner.y);
        high.x = std::max(high.x, corner.x);
        high.y = std::max(high.y, corner.y);
    }
    Box box;
    box.x_first = pixel_of(low.x);
    box.y_first = pixel_of(low.y);
    box.x_last = pixel_of(high.x);
    box.y_last = pixel_of(high.y);
    if (box.x_first < 0) box.x_first = 0;
    if (box.y_first < 0) box.y_first = 0;
    if (box.x_last >= width) box.x_last = width - 1;
    if (box.y_last >= height) box.y_last = height - 1;
    return box;
}
