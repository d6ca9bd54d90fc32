// Soft shadows of a light with a width: percentage-closer soft shadows.                                Fernando 2005
#pragma once

#include "raster/fragments.hpp"
#include "shadows/map_points.hpp"

namespace kreda::shadows {

/// Half the width of the cone of rays from a point at distance `receiver` to a light of the given half width, where it
/// passes the distance `blocker`, as the light's picture shows it: in tangents, or in world units (parallel rays).
/// By similar triangles; twice this, taken to the receiver, is the penumbra  w_light (d_r - d_b) / d_b. Distances > 0.
inline float half_cone(float light_half_width, float receiver, float blocker, bool perspective) {
    const float behind = receiver - blocker;
    const float spread = perspective ? behind / (receiver * blocker) : behind;
    return light_half_width * (spread > 0.0f ? spread : 0.0f);
}

/// What stands between the points of a batch and a light with a width.
struct SoftShadow {
    raster::Channel blocker;  ///< mean distance of the blockers from the light's plane, world units
    raster::Channel blocked;  ///< 1: there are some, 0: the whole light is seen
};

/// Step one: which texels lie within the cone of rays from the point to the light, and nearer than the point?
void find_blockers(const ShadowMap& map, const MapPoints& points, int lanes, SoftShadow& soft);

/// Step two and three: the penumbra's width from the blockers, and the share of that many texels that are lit.
void filter_penumbra(const ShadowMap& map, const MapPoints& points, int lanes, const SoftShadow& soft,
                     raster::Channel& shadow);

/// For pictures: distance from the point back to its blockers, and the width of the penumbra, world units.
void penumbra_widths(const ShadowMap& map, const MapPoints& points, int lanes, const SoftShadow& soft,
                     raster::Channel& blocker_distance, raster::Channel& penumbra);

}  // namespace kreda::shadows
