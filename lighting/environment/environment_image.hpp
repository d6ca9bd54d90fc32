// Environments as files hold them: equirectangular images, repaired, and the cube map made from one or from a sky.
//   column   u = 1/2 + atan2(z, x) / 2 pi    (+x in the middle, -z at a quarter, +z at three quarters)
//   row      v = 1/2 - atan2(y, sqrt(x^2 + z^2)) / pi    (+y on top)
#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lighting/environment/cube_map.hpp"
#include "lighting/environment/progress.hpp"
#include "lighting/environment/sky.hpp"
#include "raster/image.hpp"
#include "raster/trigonometry.hpp"

namespace kreda::lighting {

/// What was wrong with an image: texels, each counted once, by the worst of its channels.
struct EnvironmentRepairs {
    std::int64_t nan = 0, infinite = 0, negative = 0;  ///< texels
    std::int64_t too_bright = 0;                       ///< finite, above kMaxRadiance

    /// How many texels were repaired.
    [[nodiscard]] std::int64_t total() const {
        return nan + infinite + negative + too_bright;
    }
};

/// Radiance beyond this is cut: sums over all texels must stay finite.
inline constexpr float kMaxRadiance = 1e9f;

/// Make every value a radiance in [0, kMaxRadiance]: NaN becomes the mean of its finite neighbours (0 without any),
/// +infinity the largest finite value of the image, negative ones (also -infinity) 0, larger ones kMaxRadiance.
EnvironmentRepairs repair_environment(raster::Image& image);

/// Where a direction of a length in [1e-15, 1e15] lies in an equirectangular image: u, v in [0, 1].
inline glm::vec2 equirect_point(const glm::vec3& d) {
    const float azimuth = raster::atan2_in_turns(d.z, d.x);
    const float elevation = raster::atan2_in_turns(d.y, std::sqrt(d.x * d.x + d.z * d.z));
    return {raster::saturate(0.5f + azimuth), raster::saturate(0.5f - 2.0f * elevation)};
}

/// The unit direction of a point of an equirectangular image; the inverse of equirect_point.
inline glm::vec3 equirect_direction(const glm::vec2& point) {
    const raster::SinCos azimuth = raster::sin_cos_of_turns(point.x - 0.5f);
    const raster::SinCos polar = raster::sin_cos_of_turns(0.5f * point.y);
    return {polar.sin * azimuth.cos, polar.cos, polar.sin * azimuth.sin};
}

/// The solid angle of a texel in row y [sr], exact   (2 pi / W) (cos theta_y - cos theta_(y+1))
inline double equirect_solid_angle(int width, int height, int y) {
    constexpr double kTwoPi = 6.283185307179586476925;
    const double upper = raster::cos_of_turns_in_double(0.5 * y / height);
    const double lower = raster::cos_of_turns_in_double(0.5 * (y + 1) / height);
    return kTwoPi / width * (upper - lower);
}

/// An equirectangular image ready to be filtered: four floats a texel, and a border of one texel that wraps around the
/// meridian and continues over each pole on the other side (azimuth + pi).
struct EquirectMap {
    int width = 0, height = 0;  ///< texels, without the border
    std::vector<float> texels;  ///< (height + 2) rows of (width + 2) texels
};

/// Bytes of the texels of such a map, made from an image of that size.
[[nodiscard]] std::size_t bytes_of_equirect_map(int width, int height);

/// Colour or grey; must be repaired.
[[nodiscard]] EquirectMap make_equirect_map(const raster::Image& image);

/// The image in a direction, bilinear.
[[nodiscard]] glm::vec3 sample_equirect(const EquirectMap& map, const glm::vec3& direction);

/// How an environment stands in the scene: turned about +y, and its light multiplied.
struct Placement {
    float cos_rotation = 1.0f;  ///< of the angle about +y
    float sin_rotation = 0.0f;  ///< of the same angle
    float intensity = 1.0f;     ///< multiplies its radiance, >= 0
};

/// A cube map with all its mip levels. Each texel of level 0 is the mean of n x n directions, weighted with their solid
/// angles. `size` is a power of two.
[[nodiscard]] CubeMap cube_from_equirect(const raster::Image& image, int size, const Placement& placement = {},
                                         const Progress& progress = {});
/// A cube map of a built-in sky, `size` texels a side.
[[nodiscard]] CubeMap cube_from_sky(Sky sky, int size, const Placement& placement = {}, const Progress& progress = {});

/// The n of an image: no texel of it is passed over. And of a sky.
[[nodiscard]] int directions_for(int image_width, int image_height, int size);
/// Directions a side of a texel, over which a sky is averaged.
inline constexpr int kSkyDirections = 4;

/// Texels a side of a cube map that is as fine as an image of this width (a quarter of it, rounded up to a power of
/// two), at least 128 and at most `largest`.
[[nodiscard]] int cube_size_for(int image_width, int largest);

}  // namespace kreda::lighting
