#include "shadows/projected_triangles.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "raster/clip.hpp"
#include "raster/convex_polygon.hpp"
#include "raster/triangle_setup.hpp"

namespace kreda::shadows {

namespace {

using raster::ScreenVertex;

std::int64_t floor_division(std::int64_t a, std::int64_t b) {
    const std::int64_t quotient = a / b;
    return quotient - (a % b != 0 && (a < 0) != (b < 0));
}

/// Orient clockwise, and keep the triangle if it may cover a sample of the image.
void append(ProjectedTriangle t, const raster::Viewport& viewport, std::vector<ProjectedTriangle>& triangles) {
    const std::int64_t area2 = raster::edge_function(t.a.x, t.a.y, t.b.x, t.b.y, t.c.x, t.c.y);
    if (area2 == 0) return;
    t.is_front = area2 < 0;
    if (t.is_front) std::swap(t.b, t.c);
    const raster::SampleBox box = sample_box(t.a, t.b, t.c, viewport.width, viewport.height);
    if (box.x_first <= box.x_last && box.y_first <= box.y_last) triangles.push_back(t);
}

void append_fan(const raster::ClipPolygon& polygon, const raster::Viewport& viewport,
                std::vector<ProjectedTriangle>& triangles) {
    std::array<ScreenVertex, raster::ClipPolygon::kMaxCorners> corner;
    for (int i = 0; i < polygon.count; ++i) corner[i] = to_screen(polygon.vertex[i].position, viewport);
    if (polygon.count < 3) return;
    const int apex = raster::fan_apex(corner.data(), polygon.count);
    raster::for_each_of_fan(apex, polygon.count, [&](int i, int j, int k) {
        append({corner[i], corner[j], corner[k]}, viewport, triangles);
    });
}

/// Narrow a span to the samples on the inner side of edge a b: E(x) = E(0) + x step must reach `least`.
void narrow(const ScreenVertex& a, const ScreenVertex& b, int y, SampleSpan& span) {
    const std::int64_t p_y = raster::centre_of(y);
    const std::int64_t least = raster::least_inside(b.x - a.x, b.y - a.y);
    const std::int64_t lack = least - raster::edge_function(a.x, a.y, b.x, b.y, raster::kPixelCentre, p_y);
    const std::int64_t step = std::int64_t{a.y - b.y} * raster::kSubpixels;
    if (step > 0) span.first = static_cast<int>(std::max<std::int64_t>(span.first, -floor_division(-lack, step)));
    if (step < 0) span.last = static_cast<int>(std::min<std::int64_t>(span.last, floor_division(-lack, -step)));
    if (step == 0 && lack > 0) span.last = span.first - 1;
}

}  // namespace

void append_on_screen(const glm::vec4& a, const glm::vec4& b, const glm::vec4& c, const raster::Viewport& viewport,
                      std::vector<ProjectedTriangle>& triangles) {
    const float guard_x = raster::guard_band_ndc(viewport.width);
    const float guard_y = raster::guard_band_ndc(viewport.height);
    const auto fits = [&](const glm::vec4& p) { return raster::inside_guard_band(p, guard_x, guard_y); };
    if (fits(a) && fits(b) && fits(c)) {
        return append({to_screen(a, viewport), to_screen(b, viewport), to_screen(c, viewport)}, viewport, triangles);
    }
    for (const raster::FarSide side : {raster::FarSide::before, raster::FarSide::beyond}) {
        append_fan(clip_triangle(a, b, c, guard_x, guard_y, side), viewport, triangles);
    }
}

SampleSpan covered_in_row(const ProjectedTriangle& t, int y, int width) {
    SampleSpan span{0, width - 1};
    narrow(t.a, t.b, y, span);
    narrow(t.b, t.c, y, span);
    narrow(t.c, t.a, y, span);
    return span;
}

}  // namespace kreda::shadows
