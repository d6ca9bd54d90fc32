// Convex polygons of a few corners: cut by a plane, and drawn as a fan of triangles.
#pragma once

#include <array>

namespace kreda::raster {

/// A convex polygon with at most kMostCorners corners, without allocation.
template <class Corner, int kMostCorners>
struct ConvexPolygon {
    std::array<Corner, kMostCorners> corner{};  ///< in their order around it; the first `count` of them
    int count = 0;                              ///< corners; 0: nothing is left
};

/// The part of a convex polygon where distance(corner) >= 0, or with keep_inside = false what that cuts off.
/// between(inside, outside, t) is the corner at the share t of the way from the first to the second. It is always asked
/// from the inner end: two polygons that share an edge get the same corner, to the last bit. What finds no room is left
/// out.                                                                                      Sutherland & Hodgman 1974
template <class Corner, int kMostCorners, class Distance, class Between>
ConvexPolygon<Corner, kMostCorners> cut_polygon(const ConvexPolygon<Corner, kMostCorners>& in, Distance distance,
                                                Between between, bool keep_inside = true) {
    ConvexPolygon<Corner, kMostCorners> out;
    for (int i = 0; i < in.count && out.count + 2 <= kMostCorners; ++i) {
        const Corner& here = in.corner[i];
        const Corner& next = in.corner[(i + 1) % in.count];
        const double d_here = distance(here), d_next = distance(next);
        const bool leaves = d_here >= 0.0 && d_next < 0.0, enters = d_here < 0.0 && d_next >= 0.0;
        if ((d_here >= 0.0) == keep_inside) out.corner[out.count++] = here;
        if (leaves) out.corner[out.count++] = between(here, next, d_here / (d_here - d_next));
        if (enters) out.corner[out.count++] = between(next, here, d_next / (d_next - d_here));
    }
    return out;
}

/// use(i, j, k) with the corners of each triangle of the fan around corner `apex` of a convex polygon.
template <class Use>
void for_each_of_fan(int apex, int count, Use use) {
    for (int i = 1; i + 1 < count; ++i) use(apex, (apex + i) % count, (apex + i + 1) % count);
}

}  // namespace kreda::raster
