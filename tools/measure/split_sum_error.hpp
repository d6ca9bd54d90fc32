// How far the split sum is from the integral: the specular reflection of an environment, sample by sample.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "raster/image.hpp"
#include "scene/render/render.hpp"

namespace kreda::tools {

/// What a sample reflects of the environment as a mirror does, blurred by its roughness.
struct SpecularSample {
    glm::vec3 radiance;
    float n_dot_v;
    float roughness;
    float metallic;
};

/// The picture and the samples that see something, row by row. Two pictures of a scene with other settings of its
/// environment have their samples in the same order.
struct SpecularPicture {
    raster::Image film;
    std::vector<SpecularSample> samples;
};

/// The buffers keep the environment for the next picture.
[[nodiscard]] SpecularPicture draw_specular(const scene::Scene& scene, scene::RenderBuffers& buffers);

/// One unit ball of metal, F0 = 0.9, height-correlated Smith, in this environment, seen from afar along -z.
[[nodiscard]] scene::Scene metal_ball(const scene::EnvironmentSettings& environment, float roughness, int side);

/// The same with the integral itself, so many samples a point.
[[nodiscard]] scene::Scene with_reference(scene::Scene scene, int samples);

/// sum of |split - exact| / sum of exact, in percent, over the metals of a roughness with n.v in [from, to). On a ball:
/// every n.v counts as much as any other (a sample weighs 1 / n.v; most of a ball's samples look at you).
[[nodiscard]] double error_percent(const SpecularPicture& split, const SpecularPicture& exact, float roughness,
                                   float from, float to);

}  // namespace kreda::tools
