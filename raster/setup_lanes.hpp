// A tile's triangles that are prepared side by side: corners go in, edges, depth planes and boxes come out.
#pragma once

#include <cstdint>

#include "raster/screen_lanes.hpp"
#include "raster/tile_triangle.hpp"

namespace kreda::raster {

/// One edge of each triangle, a lane a triangle.
struct EdgeLanes {
    std::int32_t start[kScreenLanes];   ///< see SampleEdge
    std::int32_t step_x[kScreenLanes];  ///< to the right
    std::int32_t step_y[kScreenLanes];  ///< down

    /// The edge of triangle i.
    void set(int i, const SampleEdge& e) {
        start[i] = e.start;
        step_x[i] = e.step_x;
        step_y[i] = e.step_y;
    }
    /// As it was set.
    [[nodiscard]] SampleEdge at(int i) const {
        return {start[i], step_x[i], step_y[i]};
    }
};

/// The triangles themselves.
struct SetupLanes {
    ScreenLanes a, b, c;                                       ///< corners, clockwise on the screen
    std::uint32_t id[kScreenLanes];                            ///< triangle_id()
    EdgeLanes ab, bc, ca;                                      ///< from corner to corner
    float dz_dx[kScreenLanes], dz_dy[kScreenLanes];            ///< slopes of the depth planes
    float z_min[kScreenLanes], z_max[kScreenLanes];            ///< of the three corners
    std::int32_t x_first[kScreenLanes], x_end[kScreenLanes];   ///< columns of the box, without the end
    std::int32_t y_first[kScreenLanes], y_last[kScreenLanes];  ///< its rows, both included
    std::uint32_t covered[kScreenLanes];                       ///< covered_samples()

    /// What was found out of triangle i, whose corners are there.
    void set(int i, const TileTriangle& t, std::uint32_t samples) {
        covered[i] = samples;
        ab.set(i, t.edges.ab);
        bc.set(i, t.edges.bc);
        ca.set(i, t.edges.ca);
        dz_dx[i] = t.depth.dz_dx;
        dz_dy[i] = t.depth.dz_dy;
        z_min[i] = t.depth.z_min;
        z_max[i] = t.depth.z_max;
        x_first[i] = t.box.x_first;
        x_end[i] = t.box.x_end;
        y_first[i] = t.box.y_first;
        y_last[i] = t.box.y_last;
    }
    /// The depth plane of triangle i.
    [[nodiscard]] DepthPlane depth_at(int i) const {
        return {a.x[i], a.y[i], a.z[i], dz_dx[i], dz_dy[i], z_min[i], z_max[i]};
    }
    /// All of triangle i.
    [[nodiscard]] TileTriangle at(int i) const {
        return {{ab.at(i), bc.at(i), ca.at(i)}, depth_at(i), {x_first[i], x_end[i], y_first[i], y_last[i]}};
    }
};

}  // namespace kreda::raster
