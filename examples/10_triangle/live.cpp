// live: A1 covers
// Three edge functions tell whether a pixel's centre lies inside. This one
// takes the edges with it: pixels on an edge that two triangles share are
// drawn twice. Let the top-left rule decide where E is 0. The other functions
// are given.
#include "assignment.hpp"

bool covers(const Triangle& t, int x, int y) {
    const Point p{x * 256 + 128, y * 256 + 128};
    const std::int64_t e_ab = edge_function(t.a, t.b, p);
    const std::int64_t e_bc = edge_function(t.b, t.c, p);
    const std::int64_t e_ca = edge_function(t.c, t.a, p);
    return e_ab >= 0 && e_bc >= 0 && e_ca >= 0;
}
