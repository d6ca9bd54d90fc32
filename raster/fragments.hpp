// Fragments: the visible samples of one tile that share a material, as a structure of arrays.
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "raster/platform.hpp"
#include "raster/rasterize_tile.hpp"

namespace kreda::raster {

/// How many points are shaded together at most: their channels together stay in the first two caches.
inline constexpr int kBatchCapacity = 512;

/// A run may write a few lanes beyond the batch's end before the next batch starts.
inline constexpr int kChannelSize = kBatchCapacity + kTileSide;

/// One number for each point of a batch.
struct Channel {
    alignas(64) float value[kChannelSize];  ///< those past the batch's count hold anything

    /// Its value at point i.
    [[nodiscard]] float at(int i) const {
        return value[i];
    }
    /// Replaces it.
    void set(int i, float v) {
        value[i] = v;
    }
};

/// Three numbers for each point: a vector or a colour.
struct Channel3 {
    alignas(64) float x[kChannelSize];  ///< or red
    alignas(64) float y[kChannelSize];  ///< or green
    alignas(64) float z[kChannelSize];  ///< or blue

    /// Its value at point i.
    [[nodiscard]] glm::vec3 at(int i) const {
        return {x[i], y[i], z[i]};
    }
    /// Replaces it.
    void set(int i, const glm::vec3& v) {
        x[i] = v.x;
        y[i] = v.y;
        z[i] = v.z;
    }
};

/// Samples of a row that see the same triangle: neighbours, or every step-th.
struct Run {
    std::uint16_t x = 0, y = 0;  ///< first sample, within the tile
    std::uint16_t count = 0;     ///< samples, at least 1
    std::uint16_t step = 1;  ///< from one sample to the next; more where not every sample is lit (shading_points.hpp)
    std::uint32_t material = 0;  ///< index into the frame's materials
    std::uint32_t triangle = 0;  ///< triangle_id()
};

/// Attributes of the points of a batch, interpolated. Those that the plan does not ask for hold nothing.
struct Fragments {
    int count = 0;  ///< points, at most kBatchCapacity
    std::uint32_t
        sample[kChannelSize];  ///< its number in the picture, row by row from the top; only for what was found there
    Channel3 position;         ///< world space
    Channel3 normal;           ///< world space, as interpolated: not normalized
    Channel3
        face_normal;  ///< world space, perpendicular to the triangle, on the side of the vertices' normals; any length
    Channel3 color;   ///< lit at the vertices (Gouraud) or once a triangle (flat)
    Channel fog;      ///< fog factor of the vertices
    Channel u, v;     ///< texture coordinates
    Channel du_dx, dv_dx;  ///< u and v of the sample to the right minus those here, both on this sample's triangle
    Channel du_dy, dv_dy;  ///< the same for the sample below
    Channel3 tangent;      ///< world space, along growing u, as interpolated: not normalized
    Channel tangent_side;  ///< > 0: the bitangent is n x t; < 0: t x n
};

/// Which attributes the shading of the batch reads.
struct FragmentNeeds {
    bool position = false;     ///< world space
    bool normal = false;       ///< as interpolated
    bool face_normal = false;  ///< with normal
    bool color = false;        ///< light of the vertices
    bool uv = false;           ///< texture coordinates
    bool uv_steps = false;     ///< with uv: how far it is to the neighbouring samples' uv
    bool tangent = false;      ///< of the mesh, or from its uv
    bool fog = false;          ///< fog factor of the vertices
    bool two_sided = false;    ///< normals, tangents and colours of the side that is seen (ScreenTriangle::behind)

    /// Is anything needed beyond visibility?
    [[nodiscard]] bool any() const {
        return position || normal || face_normal || color || uv || tangent || fog;
    }
};

/// Whether attributes are divided by w (docs/13_perspective.md).
enum class AttributeInterpolation { perspective, affine };

/// Find the runs of a tile, row by row from the top, left to right. `runs` has room for one a sample. Returns their
/// number.
int collect_runs(const TileVisibility& tile, const TileArea& area, const TriangleSet& set, Run* runs);

/// Interpolate the attributes asked for over `run_count` runs, one behind the other, into the batch.
///   lambda_i = E_i / (E_0 + E_1 + E_2)      q_i = lambda_i / w_i      a = sum q_i a_i / sum q_i       Heckbert &
///   Moreton 1991
/// E_i are the exact integers (in double they stay exact up to 2^53); `affine` leaves out 1/w, to show why not.
/// Steps of uv to the neighbours come from the plane of the triangle itself, wherever it ends, so they do not depend on
/// tiles, runs or other triangles:   u' - u = sum dq_i (u_i - u) / sum (q_i + dq_i).
/// two_sided: where a triangle is seen from behind, its normal, its face normal and its tangent frame (t, and b by its
/// side) are turned, so that a bent normal is turned as a whole; its colour is that of the far side.
/// The runs hold at most kBatchCapacity samples together. `spacing`: how many samples away what counts as a neighbour
/// is, where one of a block is lit.
void interpolate_runs(const VertexStreams& streams, const TriangleSet& set, const TileArea& area, const Run* runs,
                      int run_count, const FragmentNeeds& needs, AttributeInterpolation interpolation,
                      Fragments& fragments, int spacing = 1);

}  // namespace kreda::raster
