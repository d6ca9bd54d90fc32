#include "shadows/light_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>

#include "raster/visibility.hpp"

namespace kreda::shadows {

namespace {

constexpr int kMaxGridSide = 4096;

/// Axes across a direction: where its smallest component is, the cross product is safe.
GridView view_along(const glm::dvec3& direction) {
    const glm::dvec3 d = glm::abs(direction);
    const glm::dvec3 helper = d.x <= d.y && d.x <= d.z ? glm::dvec3(1, 0, 0)
                              : d.y <= d.z             ? glm::dvec3(0, 1, 0)
                                                       : glm::dvec3(0, 0, 1);
    const glm::dvec3 right = glm::normalize(glm::cross(helper, direction));
    const glm::dvec3 up = glm::normalize(glm::cross(direction, right));
    return {glm::dvec4(right, 0.0), glm::dvec4(up, 0.0), glm::dvec4(0, 0, 0, 1)};
}

/// Face 2 axis + (negative side) of the cube around a point.
GridView view_of_face(const glm::dvec3& centre, int face) {
    glm::dvec3 rows[3] = {};
    rows[0][(face / 2 + 1) % 3] = 1.0;
    rows[1][(face / 2 + 2) % 3] = 1.0;
    rows[2][face / 2] = face % 2 == 0 ? 1.0 : -1.0;
    const auto form = [&](const glm::dvec3& row) { return glm::dvec4(row, -glm::dot(row, centre)); };
    return {form(rows[0]), form(rows[1]), form(rows[2])};
}

/// A box around all points, a little wider, so that it has a size and no point lies on its border.
void fit_box(LightGrid& grid) {
    grid.low = glm::dvec2(HUGE_VAL);
    grid.high = glm::dvec2(-HUGE_VAL);
    for (const LightPoint& point : grid.points) {
        const glm::dvec2 seen = glm::dvec2(point.q) / point.q.z;
        grid.low = glm::min(grid.low, seen);
        grid.high = glm::max(grid.high, seen);
    }
    const glm::dvec2 size = grid.high - grid.low;
    const double margin = 1e-6 * std::max({size.x, size.y, glm::length(grid.low), glm::length(grid.high), 1e-3});
    grid.low -= margin;
    grid.high += margin;
}

/// About one cell a point, the cells as square as that allows.
void choose_cells(LightGrid& grid) {
    const glm::dvec2 size = grid.high - grid.low;
    const double points = static_cast<double>(grid.points.size());
    const auto side = [](double cells) { return std::clamp(static_cast<int>(std::lround(cells)), 1, kMaxGridSide); };
    grid.columns = side(std::sqrt(points * size.x / size.y));
    grid.rows = side(points / grid.columns);
}

/// Counting sort of the points by cell; within a cell they keep the order of the frame.
void sort_points(LightGrid& grid) {
    const auto cell_of = [&](const LightPoint& point) {
        const glm::dvec2 place = grid.place(point.q);
        const int column = std::clamp(static_cast<int>(place.x), 0, grid.columns - 1);
        const int row = std::clamp(static_cast<int>(place.y), 0, grid.rows - 1);
        return static_cast<std::size_t>(row) * grid.columns + column;
    };
    grid.begin.assign(static_cast<std::size_t>(grid.columns) * grid.rows + 2, 0);
    for (const LightPoint& point : grid.points) ++grid.begin[cell_of(point) + 2];
    for (std::size_t cell = 2; cell < grid.begin.size(); ++cell) grid.begin[cell] += grid.begin[cell - 1];
    std::vector<LightPoint> sorted(grid.points.size());
    for (const LightPoint& point : grid.points) sorted[grid.begin[cell_of(point) + 1]++] = point;
    grid.begin.pop_back();
    grid.points = std::move(sorted);
}

}  // namespace

std::vector<GridView> grid_views(const ShadowLight& light) {
    if (light.kind == LightKind::directional) return {view_along(light.direction)};
    std::vector<GridView> views;
    views.reserve(6);
    for (int face = 0; face < 6; ++face) views.push_back(view_of_face(light.position, face));
    return views;
}

int view_of(const ShadowLight& light, const glm::vec3& p) {
    if (light.kind == LightKind::directional) return 0;
    const glm::dvec3 d = glm::dvec3(p) - glm::dvec3(light.position);
    const glm::dvec3 length = glm::abs(d);
    const int axis = length.x >= length.y && length.x >= length.z ? 0 : length.y >= length.z ? 1 : 2;
    if (length[axis] == 0.0) return -1;
    return 2 * axis + (d[axis] > 0.0 ? 0 : 1);
}

std::vector<LightGrid> make_light_grids(const ShadowLight& light, const VisibleSamples& samples) {
    const std::vector<GridView> views = grid_views(light);
    std::vector<LightGrid> grids(views.size());
    for (std::size_t v = 0; v < views.size(); ++v) grids[v].view = views[v];
    for (std::uint32_t i = 0; i < samples.depth.size(); ++i) {
        if (samples.depth[i] >= raster::kClearDepth) continue;
        const int v = view_of(light, samples.position[i]);
        if (v >= 0) grids[v].points.push_back({project(views[v], samples.position[i]), i});
    }
    std::erase_if(grids, [](const LightGrid& grid) { return grid.points.empty(); });
    for (LightGrid& grid : grids) {
        fit_box(grid);
        choose_cells(grid);
        sort_points(grid);
    }
    return grids;
}

}  // namespace kreda::shadows
