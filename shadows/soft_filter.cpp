#include "shadows/soft_filter.hpp"

#include <algorithm>
#include <cmath>

#include "raster/platform.hpp"
#include "shadows/filter_taps.hpp"

namespace kreda::shadows {

namespace {

using raster::Channel;

/// Cells a filter reads at most on each side of its centre. A wider filter has larger cells, not more.
constexpr float kSearchCells = 8.0f;
constexpr float kFilterCells = 12.0f;

/// What is the same for all points of the batch.
struct SoftSetup {
    PictureScale scale;
    float light_half_width = 0.0f;
    float nearest = 0.0f;
    TexelGrid grid;
    bool perspective = false;
};

SoftSetup soft_setup(const ShadowMap& map) {
    const LightView& view = map.plan.views.front();
    return {picture_scale(view, map.size()), 0.5f * map.plan.settings.light_size, map.nearest, texel_grid(map),
            view.perspective};
}

/// How a filter lies over the map around each point of a batch, all in texels. Cells stand on a grid that does not move
/// with the point, so neighbouring points read the same ones.
struct Windows {
    Channel half_u, half_v;  ///< half the filter's width and height
    Channel cell_u, cell_v;  ///< width and height of a cell, at least 1
    int cells = 0;           ///< on each side of the centre, the most of the batch
};

inline float cell_side(float half, float most_cells) {
    const float side = half / most_cells;
    return side > 1.0f ? side : 1.0f;
}

/// The most cells of any point on one side.
inline int most_cells(const Windows& w, int lanes, float limit) {
    float most = 0.0f;
    for (int i = 0; i < lanes; ++i) {  // not vectorized: without -ffast-math a maximum is taken in order; once a filter
        const float u = w.half_u.at(i) / w.cell_u.at(i);
        const float v = w.half_v.at(i) / w.cell_v.at(i);
        const float here = u > v ? u : v;
        most = here > most ? here : most;
    }
    return static_cast<int>(std::ceil(std::min(most, limit)));
}

/// A window as wide as the cone from the point to the light, at the distance of the nearest caster of all.
KREDA_BATCH_LOOP void search_windows(const MapPoints& points, int lanes, SoftSetup s, Windows& w) {
    for (int i = 0; i < lanes; ++i) {
        const float half = half_cone(s.light_half_width, points.distance.at(i), s.nearest, s.perspective);
        w.half_u.set(i, half * s.scale.texels_per_unit.x);
        w.half_v.set(i, half * s.scale.texels_per_unit.y);
        w.cell_u.set(i, cell_side(w.half_u.at(i), kSearchCells));
        w.cell_v.set(i, cell_side(w.half_v.at(i), kSearchCells));
    }
}

/// One cell of a window around a point at `at`: its left edge on the map's axis, from the number of cells to the
/// point's own.
inline float cell_begin(float at, float cell, float offset) {
    return (std::floor(at / cell) + offset) * cell;
}

// The map and the sums are parameters of their own: see add_tap() in shadow_filters.cpp.

/// The loop of search_cell(). `perspective` is a parameter because GCC only vectorizes where it is a constant.
inline void search_lanes(const MapPoints& points, int lanes, const float* __restrict distances, SoftSetup s,
                         bool perspective, const Windows& w, float column, float row, float* __restrict sum,
                         float* __restrict count) {
    for (int i = 0; i < lanes; ++i) {
        const float u = cell_begin(points.u.at(i), w.cell_u.at(i), column) + 0.5f * w.cell_u.at(i);
        const float v = cell_begin(points.v.at(i), w.cell_v.at(i), row) + 0.5f * w.cell_v.at(i);
        const float d_u = u - points.u.at(i);
        const float d_v = v - points.v.at(i);
        const float blocker = distances[points.face_begin[i] + place_of_texel(u, v, s.grid)];
        const float here = distance_beside(points, i, d_u, d_v);
        const float half = half_cone(s.light_half_width, points.distance.at(i), blocker, perspective);
        const bool in_cone_u = std::abs(d_u) <= half * s.scale.texels_per_unit.x + 0.5f * w.cell_u.at(i);
        const bool in_cone_v = std::abs(d_v) <= half * s.scale.texels_per_unit.y + 0.5f * w.cell_v.at(i);
        const bool blocks = (blocker < here) & in_cone_u & in_cone_v;
        sum[i] += blocks ? blocker : 0.0f;
        count[i] += blocks ? 1.0f : 0.0f;
    }
}

/// Count cell (column, row) of the search for those points to which it blocks a part of the light.
KREDA_BATCH_LOOP void search_cell(const MapPoints& points, int lanes, const float* __restrict distances,
                                  const SoftSetup& setup, const Windows& w, float column, float row,
                                  float* __restrict sum, float* __restrict count) {
    if (setup.perspective) {
        search_lanes(points, lanes, distances, setup, true, w, column, row, sum, count);
    } else {
        search_lanes(points, lanes, distances, setup, false, w, column, row, sum, count);
    }
}

KREDA_BATCH_LOOP void start_sums(int lanes, Channel& a, Channel& b) {
    for (int i = 0; i < lanes; ++i) {  // not vectorized: GCC makes it calls of memset
        a.set(i, 0.0f);
        b.set(i, 0.0f);
    }
}

KREDA_BATCH_LOOP void mean_blocker(int lanes, const Channel& sum, const Channel& count, SoftShadow& soft) {
    for (int i = 0; i < lanes; ++i) {
        const float n = count.at(i);
        soft.blocked.set(i, n > 0.0f ? 1.0f : 0.0f);
        soft.blocker.set(i, sum.at(i) / (n > 0.0f ? n : 1.0f));
    }
}

/// A window as wide as the penumbra, at least one texel.
KREDA_BATCH_LOOP void filter_windows(const MapPoints& points, int lanes, const SoftShadow& soft, SoftSetup s,
                                     Windows& w) {
    for (int i = 0; i < lanes; ++i) {
        const float half = half_cone(s.light_half_width, points.distance.at(i), soft.blocker.at(i), s.perspective);
        const float half_u = soft.blocked.at(i) * half * s.scale.texels_per_unit.x;
        const float half_v = soft.blocked.at(i) * half * s.scale.texels_per_unit.y;
        w.half_u.set(i, half_u > 0.5f ? half_u : 0.5f);
        w.half_v.set(i, half_v > 0.5f ? half_v : 0.5f);
        w.cell_u.set(i, cell_side(w.half_u.at(i), kFilterCells));
        w.cell_v.set(i, cell_side(w.half_v.at(i), kFilterCells));
    }
}

/// Length of the part of a cell that lies within `half` of the point.
inline float overlap(float begin, float cell, float at, float half) {
    const float left = begin > at - half ? begin : at - half;
    const float right = begin + cell < at + half ? begin + cell : at + half;
    return right > left ? right - left : 0.0f;
}

/// Add cell (column, row) of the filter: its area within the window, and that area again where it is lit.
KREDA_BATCH_LOOP void filter_cell(const MapPoints& points, int lanes, const float* __restrict distances, SoftSetup s,
                                  const Windows& w, float column, float row, float* __restrict lit,
                                  float* __restrict area) {
    for (int i = 0; i < lanes; ++i) {
        const float begin_u = cell_begin(points.u.at(i), w.cell_u.at(i), column);
        const float begin_v = cell_begin(points.v.at(i), w.cell_v.at(i), row);
        const float weight = overlap(begin_u, w.cell_u.at(i), points.u.at(i), w.half_u.at(i)) *
                             overlap(begin_v, w.cell_v.at(i), points.v.at(i), w.half_v.at(i));
        const float u = begin_u + 0.5f * w.cell_u.at(i);
        const float v = begin_v + 0.5f * w.cell_v.at(i);
        const float here = distance_beside(points, i, u - points.u.at(i), v - points.v.at(i));
        const float caster = distances[points.face_begin[i] + place_of_texel(u, v, s.grid)];
        lit[i] += here <= caster ? weight : 0.0f;
        area[i] += weight;
    }
}

KREDA_BATCH_LOOP void share_of_area(int lanes, const SoftShadow& soft, const Channel& lit, const Channel& area,
                                    Channel& shadow) {
    for (int i = 0; i < lanes; ++i) {
        const float share = lit.at(i) / (area.at(i) > 0.0f ? area.at(i) : 1.0f);
        shadow.set(i, soft.blocked.at(i) > 0.0f ? share : 1.0f);
    }
}

KREDA_BATCH_LOOP void widths_from_blockers(const MapPoints& points, int lanes, const SoftShadow& soft, SoftSetup s,
                                           Channel& blocker_distance, Channel& penumbra) {
    for (int i = 0; i < lanes; ++i) {
        const float receiver = points.distance.at(i);
        const float blocked = soft.blocked.at(i);
        const float half = half_cone(s.light_half_width, receiver, soft.blocker.at(i), s.perspective);
        blocker_distance.set(i, blocked * (receiver - soft.blocker.at(i)));
        penumbra.set(i, blocked > 0.0f ? 2.0f * half * (s.perspective ? receiver : 1.0f) : 0.0f);
    }
}

}  // namespace

void find_blockers(const ShadowMap& map, const MapPoints& points, int lanes, SoftShadow& soft) {
    const SoftSetup setup = soft_setup(map);
    Windows windows;
    Channel sum, count;
    search_windows(points, lanes, setup, windows);
    start_sums(lanes, sum, count);
    const int cells = most_cells(windows, lanes, kSearchCells);
    for (int row = -cells; row <= cells; ++row) {
        for (int column = -cells; column <= cells; ++column) {
            search_cell(points, lanes, map.distance.data(), setup, windows, static_cast<float>(column),
                        static_cast<float>(row), sum.value, count.value);
        }
    }
    mean_blocker(lanes, sum, count, soft);
}

void filter_penumbra(const ShadowMap& map, const MapPoints& points, int lanes, const SoftShadow& soft,
                     raster::Channel& shadow) {
    const SoftSetup setup = soft_setup(map);
    Windows windows;
    Channel lit, area;
    filter_windows(points, lanes, soft, setup, windows);
    start_sums(lanes, lit, area);
    const int cells = most_cells(windows, lanes, kFilterCells);
    for (int row = -cells; row <= cells; ++row) {
        for (int column = -cells; column <= cells; ++column) {
            filter_cell(points, lanes, map.distance.data(), setup, windows, static_cast<float>(column),
                        static_cast<float>(row), lit.value, area.value);
        }
    }
    share_of_area(lanes, soft, lit, area, shadow);
}

namespace {

/// Cell (column, row) of a window around point 0: where it lies, what the map holds, what it is compared with.
FilterTap cell_of_first(const ShadowMap& map, const MapPoints& points, const Windows& w, float column, float row) {
    FilterTap tap;
    tap.u = cell_begin(points.u.at(0), w.cell_u.at(0), column) + 0.5f * w.cell_u.at(0);
    tap.v = cell_begin(points.v.at(0), w.cell_v.at(0), row) + 0.5f * w.cell_v.at(0);
    const int place = points.face_begin[0] + place_of_texel(tap.u, tap.v, texel_grid(map));
    tap.stored = map.distance[static_cast<std::size_t>(place)];
    tap.compared = distance_beside(points, 0, tap.u - points.u.at(0), tap.v - points.v.at(0));
    return tap;
}

/// Cells on each side of point 0's own that its window reaches.
int cells_of_first(const Windows& w, float limit) {
    const float u = w.half_u.at(0) / w.cell_u.at(0), v = w.half_v.at(0) / w.cell_v.at(0);
    return static_cast<int>(std::ceil(std::min(std::max(u, v), limit)));
}

}  // namespace

SoftTaps soft_taps(const ShadowMap& map, const MapPoints& points) {
    const int lanes = raster::lanes_for(1);
    const SoftSetup setup = soft_setup(map);
    Windows w;
    Channel a, b;
    SoftTaps taps;
    search_windows(points, lanes, setup, w);
    taps.search_half_u = w.half_u.at(0);
    taps.search_half_v = w.half_v.at(0);
    const auto each_cell = [&](float limit, auto&& visit) {
        const int cells = cells_of_first(w, limit);
        for (int row = -cells; row <= cells; ++row) {
            for (int column = -cells; column <= cells; ++column) {
                start_sums(lanes, a, b);
                visit(static_cast<float>(column), static_cast<float>(row));
            }
        }
    };
    each_cell(kSearchCells, [&](float column, float row) {
        FilterTap tap = cell_of_first(map, points, w, column, row);
        search_cell(points, lanes, map.distance.data(), setup, w, column, row, a.value, b.value);
        tap.lit = b.at(0);
        taps.search.push_back(tap);
    });
    SoftShadow soft;
    find_blockers(map, points, lanes, soft);
    taps.blocker = soft.blocker.at(0);
    taps.blocked = soft.blocked.at(0) > 0.0f;
    filter_windows(points, lanes, soft, setup, w);
    taps.half_u = w.half_u.at(0);
    taps.half_v = w.half_v.at(0);
    each_cell(kFilterCells, [&](float column, float row) {
        FilterTap tap = cell_of_first(map, points, w, column, row);
        filter_cell(points, lanes, map.distance.data(), setup, w, column, row, a.value, b.value);
        tap.lit = a.at(0);
        tap.weight = b.at(0);
        if (tap.weight > 0.0f) taps.filter.push_back(tap);
    });
    return taps;
}

void penumbra_widths(const ShadowMap& map, const MapPoints& points, int lanes, const SoftShadow& soft,
                     raster::Channel& blocker_distance, raster::Channel& penumbra) {
    widths_from_blockers(points, lanes, soft, soft_setup(map), blocker_distance, penumbra);
}

}  // namespace kreda::shadows
