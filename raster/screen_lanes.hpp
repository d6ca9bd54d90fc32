// Screen vertices as a structure of arrays: one corner of up to 64 triangles or samples that are worked on side by
// side.
#pragma once

#include "raster/screen.hpp"

namespace kreda::raster {

/// Vertices that are worked on side by side.
inline constexpr int kScreenLanes = 64;

/// Screen vertices side by side, one array a member.
struct ScreenLanes {
    alignas(64) std::int32_t x[kScreenLanes] = {};  ///< 1/256 sample
    std::int32_t y[kScreenLanes] = {};              ///< 1/256 sample
    float z[kScreenLanes] = {};                     ///< window depth, 0..1
    float inv_w[kScreenLanes] = {};                 ///< 1/w > 0

    /// Vertex i of them.
    [[nodiscard]] ScreenVertex at(int i) const {
        return {x[i], y[i], z[i], inv_w[i]};
    }
    /// Replaces vertex i.
    void set(int i, const ScreenVertex& v) {
        x[i] = v.x;
        y[i] = v.y;
        z[i] = v.z;
        inv_w[i] = v.inv_w;
    }
};

}  // namespace kreda::raster
