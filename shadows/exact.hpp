// The exact shadow: a ray from each point to the light, against every triangle that could be in its way. What all other
// methods are measured by.
#pragma once

#include "raster/fragments.hpp"
#include "shadows/bvh.hpp"

namespace kreda::shadows {

/// Everything that casts a shadow, made ready for rays to one light.
struct ExactShadow {
    glm::dvec4 light{0.0};  ///< homogeneous, see light_ray.hpp
    Bvh bvh;                ///< over the casting triangles
};

/// Builds the tree of the casters for one light.
[[nodiscard]] ExactShadow build_exact_shadow(std::span<const Occluder> occluders, const ShadowLight& light);

/// 1 where nothing stands between the point and the light, 0 elsewhere, for the first `count` points of a batch. World
/// space.
void shadow_factors(const ExactShadow& exact, const raster::Channel3& position, int count, raster::Channel& shadow);

/// For pictures: along the ray, how far before each of the first `count` points the light is stopped, world units; 0
/// where nothing blocks.
void shadow_blockers(const ExactShadow& exact, const raster::Channel3& position, int count,
                     raster::Channel& blocker_distance);

/// The factor of all visible samples of a frame; threads share it row by row.
void exact_shadow(const ExactShadow& exact, const VisibleSamples& samples, std::span<float> shadow);

}  // namespace kreda::shadows
