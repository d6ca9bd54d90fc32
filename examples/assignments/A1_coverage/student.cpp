// A1 Coverage. Read README.md; write the four functions; check them with `./course assignment 1`.
#include "assignment.hpp"

// Twice the signed area of a, b, p: positive where p lies to the right of the way from a to b (y is down). It is exact:
// on the largest pictures it needs more than 32 bits.
std::int64_t edge_function(const Point& a, const Point& b, const Point& p) {
    (void)a, (void)b, (void)p;
    return 0;  // A1: write here
}

// Is the way from a to b a left edge or a top edge of a triangle that lies to its right?
bool is_top_left(const Point& a, const Point& b) {
    (void)a, (void)b;
    return false;  // A1: write here
}

// Does the triangle own the pixel in column x and row y? A centre on an edge belongs to it at top and left edges only.
bool covers(const Triangle& t, int x, int y) {
    (void)t, (void)x, (void)y;
    return false;  // A1: write here
}

// The smallest box of pixels of the picture that holds all corners: from the pixel that the least coordinate lies in to
// the one that the greatest lies in. A part outside of the picture is left out.
Box pixel_box(const Triangle& t, int width, int height) {
    (void)t;
    return {0, 0, width - 1, height - 1};  // A1: write here
}
