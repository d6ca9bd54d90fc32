// Looking up a shadow map: where the points of a batch lie in it, then one of three filters.
#include "raster/platform.hpp"
#include "raster/scalar_math.hpp"
#include "shadows/filter_taps.hpp"
#include "shadows/map_points.hpp"
#include "shadows/soft_filter.hpp"

namespace kreda::shadows {

namespace {

using raster::Channel;
using raster::Channel3;
using raster::lanes_for;

/// The loop of locate_in_picture(). `perspective` is a parameter because GCC only vectorizes where it is a constant.
inline void locate_lanes(const Channel3& position, const Channel3& normal, int lanes, const LightView& light_view,
                         int size, BiasTerms bias, bool perspective, MapPoints& out) {
    const glm::mat3 axes = light_view.view_from_world;
    const glm::vec3 origin = light_view.origin;
    const PictureScale scale = picture_scale(light_view, size);
    for (int i = 0; i < lanes; ++i) {
        const PointInView p = point_in_picture(axes, origin, position.at(i), normal.at(i));
        out.set(i,
                perspective ? map_point_perspective(p.q, p.n, scale, bias) : map_point_parallel(p.q, p.n, scale, bias),
                0);
    }
}

/// The points in the one picture of a directional light or a spot.
KREDA_BATCH_LOOP void locate_in_picture(const Channel3& position, const Channel3& normal, int lanes,
                                        const LightView& light_view, int size, const BiasTerms& terms, MapPoints& out) {
    if (light_view.perspective) {
        locate_lanes(position, normal, lanes, light_view, size, terms, true, out);
    } else {
        locate_lanes(position, normal, lanes, light_view, size, terms, false, out);
    }
}

KREDA_BATCH_LOOP void locate_in_cube(const Channel3& position, const Channel3& normal, int lanes,
                                     const LightView& light_view, int size, int face_stride, BiasTerms bias,
                                     MapPoints& out) {
    const glm::vec3 origin = light_view.origin;
    const PictureScale scale = picture_scale(light_view, size);
    for (int i = 0; i < lanes; ++i) {
        const PointInView p = point_in_cube(origin, position.at(i), normal.at(i));
        out.set(i, map_point_perspective(p.q, p.n, scale, bias), p.face * face_stride);
    }
}

KREDA_BATCH_LOOP void fill(int lanes, float value, Channel& channel) {
    for (int i = 0; i < lanes; ++i) channel.set(i, value);  // not vectorized: GCC makes it calls of memset
}

/// The texel into which each point of a batch falls.
struct Texels {
    alignas(64) int place[raster::kChannelSize];
};

KREDA_BATCH_LOOP void set_texels(const MapPoints& points, int lanes, TexelGrid grid, Texels& texels) {
    for (int i = 0; i < lanes; ++i) {
        texels.place[i] = points.face_begin[i] + place_of_texel(points.u.at(i), points.v.at(i), grid);
    }
}

// The map and what is written are parameters of their own because only `__restrict` tells the compiler that writing
// does not change the map; without it no loop that looks something up is vectorized.

/// One tap of a filter, (d_u, d_v) texels beside each point: add 1 where the light arrives. `tap` is the distance that
/// far from the first texel. The depth test of the camera, seen from the light: lit if nothing that casts lies nearer.
KREDA_BATCH_LOOP void add_tap(const MapPoints& points, const Texels& texels, int lanes, const float* __restrict tap,
                              float d_u, float d_v, float* __restrict lit) {
    for (int i = 0; i < lanes; ++i) {
        const float distance = distance_beside(points, i, d_u, d_v);
        lit[i] += distance <= tap[texels.place[i]] ? 1.0f : 0.0f;
    }
}

KREDA_BATCH_LOOP void scale(int lanes, float f, Channel& channel) {
    for (int i = 0; i < lanes; ++i) channel.set(i, channel.at(i) * f);
}

/// Ask memory for the rows of texels that are compared next. Points side by side lie far apart in a map of megabytes;
/// here many reads wait at once, in a comparison few.
void ask_for_rows(const ShadowMap& map, const Texels& texels, int lanes, int radius) {
    for (int v = -radius; v <= radius; ++v) {
        const float* row = map.distance.data() + v * map.stride();
        for (int i = 0; i < lanes; ++i) __builtin_prefetch(row + texels.place[i]);  // not vectorized: no formula
    }
}

/// Percentage-closer filtering: compare first, then average, over (2 radius + 1)^2 texels.  Reeves, Salesin, Cook 1987
void filter_box(const ShadowMap& map, const MapPoints& points, int lanes, int radius, Channel& shadow) {
    Texels texels;
    set_texels(points, lanes, texel_grid(map), texels);
    ask_for_rows(map, texels, lanes, radius);
    fill(lanes, 0.0f, shadow);
    for (int v = -radius; v <= radius; ++v) {
        for (int u = -radius; u <= radius; ++u) {
            const float* tap = map.distance.data() + v * map.stride() + u;
            add_tap(points, texels, lanes, tap, static_cast<float>(u), static_cast<float>(v), shadow.value);
        }
    }
    const float side = static_cast<float>(2 * radius + 1);
    scale(lanes, 1.0f / (side * side), shadow);
}

/// What the texel under each point says: how far before it the light is stopped.
KREDA_BATCH_LOOP void nearest_blocker(const MapPoints& points, const Texels& texels, int lanes,
                                      const float* __restrict distances, float* __restrict blocker_distance) {
    for (int i = 0; i < lanes; ++i) {
        const float before = points.distance.at(i) - distances[texels.place[i]];
        blocker_distance[i] = before > 0.0f ? before : 0.0f;
    }
}

}  // namespace

void locate(const ShadowMap& map, const Channel3& position, const Channel3& n, int lanes, MapPoints& points) {
    const LightView& view = map.plan.views.front();
    const BiasTerms bias = bias_terms(map.plan.settings, view.far - view.near);
    if (map.plan.views.size() == 1) return locate_in_picture(position, n, lanes, view, map.size(), bias, points);
    locate_in_cube(position, n, lanes, view, map.size(), map.face_stride(), bias, points);
}

std::vector<FilterTap> box_taps(const ShadowMap& map, const MapPoints& points, int radius) {
    const TexelGrid grid = texel_grid(map);
    Texels texels;
    set_texels(points, lanes_for(1), grid, texels);
    const int place = texels.place[0];
    const int in_face = place - points.face_begin[0] - grid.before_first;
    const int column = in_face % grid.stride - 1, row = in_face / grid.stride - 1;
    std::vector<FilterTap> taps;
    for (int v = -radius; v <= radius; ++v) {
        for (int u = -radius; u <= radius; ++u) {
            const int beside = v * map.stride() + u;
            const float d_u = static_cast<float>(u), d_v = static_cast<float>(v);
            Channel lit;
            fill(lanes_for(1), 0.0f, lit);
            add_tap(points, texels, lanes_for(1), map.distance.data() + beside, d_u, d_v, lit.value);
            taps.push_back({static_cast<float>(column + u) + 0.5f, static_cast<float>(row + v) + 0.5f,
                            map.distance[static_cast<std::size_t>(place + beside)],
                            distance_beside(points, 0, d_u, d_v), lit.at(0), 1.0f});
        }
    }
    return taps;
}

void shadow_factors(const ShadowMap& map, const raster::Channel3& position, const raster::Channel3& normal, int count,
                    raster::Channel& shadow) {
    const int lanes = lanes_for(count);
    MapPoints points;
    locate(map, position, normal, lanes, points);
    switch (map.plan.settings.filter) {
        case ShadowFilter::none: return filter_box(map, points, lanes, 0, shadow);
        case ShadowFilter::pcf: return filter_box(map, points, lanes, map.plan.settings.radius, shadow);
        case ShadowFilter::pcss: {
            SoftShadow soft;
            find_blockers(map, points, lanes, soft);
            return filter_penumbra(map, points, lanes, soft, shadow);
        }
    }
}

void shadow_blockers(const ShadowMap& map, const raster::Channel3& position, const raster::Channel3& normal, int count,
                     raster::Channel& blocker_distance, raster::Channel& penumbra) {
    const int lanes = lanes_for(count);
    MapPoints points;
    locate(map, position, normal, lanes, points);
    if (map.plan.settings.filter != ShadowFilter::pcss) {
        Texels texels;
        set_texels(points, lanes, texel_grid(map), texels);
        nearest_blocker(points, texels, lanes, map.distance.data(), blocker_distance.value);
        return fill(lanes, 0.0f, penumbra);
    }
    SoftShadow soft;
    find_blockers(map, points, lanes, soft);
    penumbra_widths(map, points, lanes, soft, blocker_distance, penumbra);
}

}  // namespace kreda::shadows
