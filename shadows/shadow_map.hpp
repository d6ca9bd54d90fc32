// Shadow maps: the scene as the light sees it, depth only, and the depth test repeated from there.       Williams 1978
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "raster/aligned_vector.hpp"
#include "raster/fragments.hpp"
#include "raster/image.hpp"
#include "raster/triangle_setup.hpp"
#include "raster/vertex_stage.hpp"
#include "shadows/light_view.hpp"
#include "shadows/shadow.hpp"

namespace kreda::shadows {

/// Distance of a texel in which nothing casts: every surface is nearer.
inline constexpr float kNoCaster = 3.0e38f;

/// How a light is drawn: its pictures, and what a map made of them is asked.
struct ShadowMapPlan {
    ShadowSettings settings;       ///< of the scene
    std::vector<LightView> views;  ///< 1, or the 6 of cube_views()
};

/// Texels that a filter reads beyond the one that a point falls into; pcss: as far as a margin is kept for it.
[[nodiscard]] int filter_margin(const ShadowSettings& settings);

/// What a light sees. A face holds size x size distances, row 0 on top, and a ring around them as wide as a filter
/// reaches over the edge, so that no tap has to ask where it is. In the ring nothing casts; the faces of a cube repeat
/// their own edge there.
struct ShadowMap {
    ShadowMapPlan plan;                     ///< how it was drawn
    raster::AlignedVector<float> distance;  ///< along the view's axis, world units; kNoCaster where nothing casts
    float nearest = kNoCaster;              ///< the least of them; pcss only
    std::vector<std::uint8_t> is_empty;     ///< one a tile, face by face: 1 where all of it says that nothing casts

    /// Texels a side, without the ring.
    [[nodiscard]] int size() const {
        return plan.settings.size;
    }
    /// Texels around each face that filters may read.
    [[nodiscard]] int ring() const {
        return plan.settings.filter == ShadowFilter::pcf ? plan.settings.radius + 1 : 1;
    }
    /// Floats from row to row.
    [[nodiscard]] int stride() const {
        return size() + 2 * ring();
    }
    /// Floats from face to face.
    [[nodiscard]] int face_stride() const {
        return stride() * stride();
    }
    /// Where the texel in column 0 and row 0 stands in its face.
    [[nodiscard]] int first_texel() const {
        return ring() * (stride() + 1);
    }
    /// Distance kept in a texel.
    [[nodiscard]] float at(int face, int column, int row) const {
        return distance[static_cast<std::size_t>(face) * face_stride() + first_texel() + row * stride() + column];
    }
};

/// The memory in which a map is drawn. Keep it from frame to frame and nothing is allocated twice.
struct ShadowMapBuffers {
    raster::VertexStreams streams;  ///< vertices as the light sees them
    raster::TriangleSet triangles;  ///< and their triangles, tile by tile
};

/// Draw a map with the rasterizer of the camera's picture. `casters`: their places in the streams are changed.
void draw_shadow_map(std::vector<raster::MeshInstance>& casters, const ShadowMapPlan& plan, ShadowMapBuffers& buffers,
                     ShadowMap& map);

/// The map's distances as an image of one channel, infinite where nothing casts. The six faces of a point light lie in
/// a row, +x -x +y -y +z -z.
[[nodiscard]] raster::Image map_distances(const ShadowMap& map);

/// shadow = share of the light that reaches each point: 1 lit .. 0 in shadow. Shape: see shadow.hpp.
/// `normal`: perpendicular to the surface, outward, any length; the bias needs it.
void shadow_factors(const ShadowMap& map, const raster::Channel3& position, const raster::Channel3& normal, int count,
                    raster::Channel& shadow);

/// What the filter found on the way, for pictures: how far before the point its blockers lie, on average, and how wide
/// that makes the penumbra (pcss; else 0). Both in world units, 0 where nothing blocks.
void shadow_blockers(const ShadowMap& map, const raster::Channel3& position, const raster::Channel3& normal, int count,
                     raster::Channel& blocker_distance, raster::Channel& penumbra);

}  // namespace kreda::shadows
