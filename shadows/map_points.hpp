// The points of a batch in a light's picture, as the filters want them.
#pragma once

#include "raster/fragments.hpp"
#include "shadows/map_point.hpp"
#include "shadows/shadow_map.hpp"

namespace kreda::shadows {

/// MapPoint by MapPoint, and where the face of each begins in the map.
struct MapPoints {
    raster::Channel u, v, distance, slope_u, slope_v;  ///< see MapPoint
    alignas(64) int face_begin[raster::kChannelSize];  ///< index of the face's first distance

    /// Puts a point at place i - begin.
    void set(int i, const MapPoint& point, int begin) {
        u.set(i, point.u);
        v.set(i, point.v);
        distance.set(i, point.distance);
        slope_u.set(i, point.slope.u);
        slope_v.set(i, point.slope.v);
        face_begin[i] = begin;
    }
};

/// Find the points of a batch in the map: pick the face, project, take off the bias.
void locate(const ShadowMap& map, const raster::Channel3& position, const raster::Channel3& normal, int lanes,
            MapPoints& points);

/// What a tap beside point i compares with the map, (d_u, d_v) texels away: the surface's plane where the bias follows
/// it.
inline float distance_beside(const MapPoints& points, int i, float d_u, float d_v) {
    return points.distance.at(i) + points.slope_u.at(i) * d_u + points.slope_v.at(i) * d_v;
}

/// How a face's texels lie in memory.
struct TexelGrid {
    float size = 0.0f;     ///< texels a side
    int stride = 0;        ///< from row to row
    int before_first = 0;  ///< where the texel in column -1 and row -1 stands
};

/// Size and strides of a map's texels.
[[nodiscard]] inline TexelGrid texel_grid(const ShadowMap& map) {
    return {static_cast<float>(map.size()), map.stride(), map.first_texel() - map.stride() - 1};
}

/// Where a texel stands in its face: what lies outside (or is NaN) counts as one texel outside, which is in the ring.
inline int place_of_texel(float u, float v, const TexelGrid& grid) {
    const float end = grid.size + 1.0f;
    const float x = u + 1.0f;
    const float y = v + 1.0f;
    const float x_positive = x > 0.0f ? x : 0.0f;
    const float y_positive = y > 0.0f ? y : 0.0f;
    const int column = static_cast<int>(x_positive < end ? x_positive : end);
    const int row = static_cast<int>(y_positive < end ? y_positive : end);
    return grid.before_first + row * grid.stride + column;
}

}  // namespace kreda::shadows
