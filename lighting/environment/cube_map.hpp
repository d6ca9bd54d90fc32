// Cube maps: a colour for every direction, stored on the six faces of a cube, at several resolutions.
//
// Faces are numbered +x, -x, +y, -y, +z, -z and lie as in OpenGL (a face seen from outside: u to the right, v down).
// Each face carries a border of one texel that repeats its neighbours' outermost texels. Bilinear filtering then never
// leaves a face, and the two faces at an edge, or the three at a corner, compute the same number there: no seam.
#pragma once

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "lighting/environment/texel_taps.hpp"
#include "raster/aligned_vector.hpp"
#include "raster/cube_face.hpp"
#include "raster/scalar_math.hpp"

namespace kreda::lighting {

using raster::kCubeFaces;

/// A point of the cube's surface.
struct CubePoint {
    int face = 0;              ///< 0..5: +x, -x, +y, -y, +z, -z
    float u = 0.0f, v = 0.0f;  ///< in [0, 1], from the left and from the top
};

/// The direction to a point of a face, not normalized: its largest component is 1.   u, v may lie beyond [0, 1].
inline glm::vec3 direction_of(const CubePoint& point) {
    const float s = 2.0f * point.u - 1.0f;
    const float t = 2.0f * point.v - 1.0f;
    const float sign = (point.face & 1) != 0 ? -1.0f : 1.0f;
    const glm::vec3 on_x{sign, -t, -sign * s};
    const glm::vec3 on_y{s, sign, sign * t};
    const glm::vec3 on_z{sign * s, -t, sign};
    const glm::vec3 on_y_or_z = point.face < 4 ? on_y : on_z;
    return point.face < 2 ? on_x : on_y_or_z;
}

/// The point of the cube in a direction of a length in [1e-15, 1e15]. The inverse of direction_of; no branch, no angle.
inline CubePoint cube_point(const glm::vec3& d) {
    const raster::CubeFace at = raster::cube_face(d);
    const float s_y_or_z = at.on_y() ? d.x : at.sign * d.x;
    const float s = at.on_x() ? -at.sign * d.z : s_y_or_z;
    const float t = at.on_y() ? at.sign * d.z : -d.y;
    const float length = std::abs(at.along);
    const float half_by_length = 0.5f / (length > raster::kMinNormal ? length : raster::kMinNormal);
    return {at.face, raster::saturate(0.5f + s * half_by_length), raster::saturate(0.5f + t * half_by_length)};
}

/// A direction of the world as the maps of an environment know it that is turned about +y: turned back.
inline glm::vec3 map_direction(const glm::vec3& d, float cos_rotation, float sin_rotation) {
    return {d.x * cos_rotation - d.z * sin_rotation, d.y, d.x * sin_rotation + d.z * cos_rotation};
}

/// The solid angle of texel (x, y) of a face of `size` texels a side [sr], exact. Over all six faces they sum to 4 pi.
///   w = A(x0, y0) - A(x0, y1) - A(x1, y0) + A(x1, y1),   A(x, y) = atan(x y / sqrt(x^2 + y^2 + 1))
[[nodiscard]] double texel_solid_angle(int size, int x, int y);

/// Where a level lies in CubeMap::texels.
struct CubeLevel {
    int size = 0;    ///< texels a side, without the border
    int offset = 0;  ///< first float
};

/// Four floats a texel: red, green, blue and nothing. A level holds 6 faces of (size + 2)^2 texels, row by row.
struct CubeMap {
    std::vector<CubeLevel> levels;        ///< the finest first
    raster::AlignedVector<float> texels;  ///< linear radiance, or what is made of it

    /// Has it no texels yet?
    [[nodiscard]] bool empty() const {
        return levels.empty();
    }
    /// The coarsest level; 0 is the finest.
    [[nodiscard]] int last_level() const {
        return static_cast<int>(levels.size()) - 1;
    }
    [[nodiscard]] std::size_t index(int level, int face, int x, int y) const {  ///< x, y from -1 to size
        const CubeLevel& at = levels[static_cast<std::size_t>(level)];
        const int side = at.size + 2;
        return static_cast<std::size_t>(at.offset) + 4 * ((std::size_t(face) * side + (y + 1)) * side + (x + 1));
    }
    /// Linear RGB of a texel; x and y from -1 (the border) to the level's size.
    [[nodiscard]] glm::vec3 texel(int level, int face, int x, int y) const {
        const float* p = &texels[index(level, face, x, y)];
        return {p[0], p[1], p[2]};
    }
    /// Replaces it.
    void set_texel(int level, int face, int x, int y, const glm::vec3& color) {
        float* p = &texels[index(level, face, x, y)];
        p[0] = color.x;
        p[1] = color.y;
        p[2] = color.z;
    }
};

/// All levels black, of the given sizes.
[[nodiscard]] CubeMap make_cube_map(const std::vector<int>& sizes);

/// Sizes of a map with all its mip levels: size, size / 2, ... 1. `size` is a power of two.
[[nodiscard]] std::vector<int> mip_sizes(int size);

/// Copy the neighbours' outermost texels into the border of a level. A corner gets the mean of the three that meet
/// there.
void fill_border(CubeMap& map, int level);

/// Each level from the one above it: means of 2 x 2 texels, weighted with their solid angles, so that the light from
/// all directions together stays the same. The sizes halve from level to level.
void fill_mip_levels(CubeMap& map);

/// The centre of texel (x, y), as a direction of any length.
inline glm::vec3 texel_direction(int size, int face, int x, int y) {
    const float scale = 1.0f / static_cast<float>(size);
    return direction_of({face, (static_cast<float>(x) + 0.5f) * scale, (static_cast<float>(y) + 0.5f) * scale});
}

/// The four texels around a point of one level, and their bilinear weights times `share`.
inline TexelTap cube_tap(const CubePoint& point, int size, int offset, float share) {
    const float x = point.u * static_cast<float>(size) + 0.5f;  // counted from the centre of the border's texel
    const float y = point.v * static_cast<float>(size) + 0.5f;
    const int left = static_cast<int>(x);
    const int top = static_cast<int>(y);
    const int side = size + 2;
    const int first = offset + 4 * ((point.face * side + top) * side + left);
    return bilinear_tap(first, 4 * side, x - static_cast<float>(left), y - static_cast<float>(top), share);
}

/// The map in a direction, bilinear in one level.
[[nodiscard]] glm::vec3 sample_level(const CubeMap& map, int level, const glm::vec3& direction);

/// The map in a direction, trilinear: lod 1.5 is the mean of levels 1 and 2. lod is clamped to the levels.
[[nodiscard]] glm::vec3 sample_trilinear(const CubeMap& map, const glm::vec3& direction, float lod);

// ------------------------------------------------------------------------------------------------ batches

/// The same for a batch of directions, one level.
void sample_level(const CubeMap& map, int level, int lanes, const raster::Channel3& directions, TapScratch& scratch,
                  raster::Channel3& colors);

/// The same for a batch of directions with a lod each.
void sample_trilinear(const CubeMap& map, int lanes, const raster::Channel3& directions, const raster::Channel& lod,
                      TapScratch& scratch, raster::Channel3& colors);

/// The same for a batch of directions with one lod for all: the same bits, sooner.
void sample_trilinear(const CubeMap& map, int lanes, const raster::Channel3& directions, float lod, TapScratch& scratch,
                      raster::Channel3& colors);

}  // namespace kreda::lighting
