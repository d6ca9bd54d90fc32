// A1: what is given. The functions at the end are yours to write, in student.cpp.
#pragma once

#include <algorithm>
#include <cstdint>

/// A place on the screen in 1/256 pixel, x to the right, y DOWN. The centre of the first pixel is (128, 128).
struct Point {
    std::int32_t x, y;
};

/// Clockwise as it is seen, with y down.
struct Triangle {
    Point a, b, c;
};

/// Pixels from x_first to x_last and y_first to y_last, these included.
struct Box {
    int x_first, y_first, x_last, y_last;
};

std::int64_t edge_function(const Point& a, const Point& b, const Point& p);
bool is_top_left(const Point& a, const Point& b);
bool covers(const Triangle& t, int x, int y);
Box pixel_box(const Triangle& t, int width, int height);
