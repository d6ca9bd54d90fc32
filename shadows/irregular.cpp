#include "shadows/irregular.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "raster/convex_polygon.hpp"
#include "shadows/bvh.hpp"
#include "shadows/row_bands.hpp"

namespace kreda::shadows {

namespace {

/// Cells are widened by this share of a cell: far more than double rounds in finding them.
constexpr double kCellMargin = 1e-6;

using Polygon = raster::ConvexPolygon<glm::dvec3, 8>;

/// The part of a convex polygon where dot(plane, corner) >= 0.
Polygon clip(const Polygon& in, const glm::dvec3& plane) {
    return cut_polygon(
        in, [&](const glm::dvec3& corner) { return glm::dot(plane, corner); },
        [](const glm::dvec3& inside, const glm::dvec3& outside, double t) { return inside + t * (outside - inside); });
}

/// What the grid sees of the triangle. Inside all four sides of the grid's box w cannot be negative.
Polygon clip_to_grid(const LightGrid& grid, const glm::dvec3 (&q)[3]) {
    Polygon polygon{{{q[0], q[1], q[2]}}, 3};
    polygon = clip(polygon, {1.0, 0.0, -grid.low.x});
    polygon = clip(polygon, {-1.0, 0.0, grid.high.x});
    polygon = clip(polygon, {0.0, 1.0, -grid.low.y});
    return clip(polygon, {0.0, -1.0, grid.high.y});
}

/// A triangle that reaches the light itself may touch any cell.
void cover_all(const LightGrid& grid, LightTriangle& triangle) {
    const double x = grid.columns, y = grid.rows;
    const glm::dvec2 corners[4] = {{0, 0}, {x, 0}, {x, y}, {0, y}};
    std::copy(std::begin(corners), std::end(corners), triangle.corner);
    triangle.corner_count = 4;
}

void place_corners(const LightGrid& grid, const Polygon& polygon, LightTriangle& triangle) {
    triangle.corner_count = polygon.count;
    for (int i = 0; i < triangle.corner_count; ++i) {
        if (!(polygon.corner[i].z > 0.0)) return cover_all(grid, triangle);
        triangle.corner[i] = grid.place(polygon.corner[i]);
    }
}

int row_at(const LightGrid& grid, double y) {
    return static_cast<int>(std::floor(std::clamp(y, 0.0, grid.rows - 1.0)));
}

/// Test the points of the cells first..last of a row against the triangle.
void test_points(const LightGrid& grid, const LightTriangle& triangle, int row, const CellRange& cells,
                 const glm::dvec4& light, const VisibleSamples& samples, std::span<float> shadow) {
    const std::size_t first_cell = static_cast<std::size_t>(row) * grid.columns;
    const std::uint32_t end = grid.begin[first_cell + cells.last + 1];
    for (std::uint32_t i = grid.begin[first_cell + cells.first]; i < end; ++i) {
        const LightPoint& point = grid.points[i];
        if (shadow[point.sample] == 0.0f) continue;
        if (shadows_point(triangle, point.q, light, samples.position[point.sample])) shadow[point.sample] = 0.0f;
    }
}

void draw_into_grid(const LightGrid& grid, std::span<const LightTriangle> triangles, const glm::dvec4& light,
                    const VisibleSamples& samples, std::span<float> shadow) {
    const int bands = count_bands(grid.rows);
#pragma omp parallel for schedule(dynamic)
    for (int band = 0; band < bands; ++band) {
        const auto [band_first, band_last] = row_band(band, grid.rows);
        for (const LightTriangle& triangle : triangles) {
            const int last_row = std::min(triangle.last_row, band_last);
            for (int row = std::max(triangle.first_row, band_first); row <= last_row; ++row) {
                const CellRange cells = cells_in_row(grid, triangle, row);
                if (cells.first <= cells.last) test_points(grid, triangle, row, cells, light, samples, shadow);
            }
        }
    }
}

}  // namespace

LightTriangle set_up(const LightGrid& grid, const Triangle& world) {
    const glm::dvec3 q[3] = {project(grid.view, world.a), project(grid.view, world.b), project(grid.view, world.c)};
    LightTriangle triangle = with_edges(world, q);
    const Polygon polygon = clip_to_grid(grid, q);
    if (polygon.count < 3) return triangle;
    place_corners(grid, polygon, triangle);
    double low = triangle.corner[0].y, high = low;
    for (int i = 1; i < triangle.corner_count; ++i) {
        low = std::min(low, triangle.corner[i].y);
        high = std::max(high, triangle.corner[i].y);
    }
    triangle.first_row = row_at(grid, low - kCellMargin);
    triangle.last_row = row_at(grid, high + kCellMargin);
    return triangle;
}

CellRange cells_in_row(const LightGrid& grid, const LightTriangle& triangle, int row) {
    const double y_low = row - kCellMargin, y_high = row + 1.0 + kCellMargin;
    double x_low = HUGE_VAL, x_high = -HUGE_VAL;
    for (int i = 0; i < triangle.corner_count; ++i) {
        const glm::dvec2& a = triangle.corner[i];
        const glm::dvec2& b = triangle.corner[(i + 1) % triangle.corner_count];
        if (std::max(a.y, b.y) < y_low || std::min(a.y, b.y) > y_high) continue;
        const auto x_at = [&](double y) { return a.y == b.y ? b.x : a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x); };
        for (const double x : {a.y >= y_low && a.y <= y_high ? a.x : x_at(a.y < y_low ? y_low : y_high),
                               b.y >= y_low && b.y <= y_high ? b.x : x_at(b.y < y_low ? y_low : y_high)}) {
            x_low = std::min(x_low, x);
            x_high = std::max(x_high, x);
        }
    }
    const auto column = [&](double x) { return static_cast<int>(std::floor(std::clamp(x, 0.0, grid.columns - 1.0))); };
    if (x_low > x_high) return {};
    return {column(x_low - kCellMargin), column(x_high + kCellMargin)};
}

std::size_t bytes_to_draw_irregular(std::size_t samples, std::size_t triangles) {
    return samples * (2 * sizeof(LightPoint) + sizeof(std::uint32_t)) +
           triangles * (sizeof(Triangle) + sizeof(LightTriangle));
}

void irregular_shadow(std::span<const Occluder> occluders, const ShadowLight& light, const VisibleSamples& samples,
                      std::span<float> shadow) {
    std::fill(shadow.begin(), shadow.end(), 1.0f);
    const std::vector<Triangle> world = gather_triangles(occluders);
    std::vector<LightTriangle> triangles(world.size());
    for (const LightGrid& grid : make_light_grids(light, samples)) {
        const int count = static_cast<int>(world.size());
#pragma omp parallel for schedule(static)
        for (int i = 0; i < count; ++i) triangles[i] = set_up(grid, world[i]);
        draw_into_grid(grid, triangles, homogeneous(light), samples, shadow);
    }
}

}  // namespace kreda::shadows
