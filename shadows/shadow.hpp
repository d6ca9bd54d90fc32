// What every way of finding shadows shares: the light, what casts, what is asked for, and the points asked about.
#pragma once

#include <cstdint>
#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "raster/cull_mode.hpp"
#include "raster/fragments.hpp"
#include "raster/screen.hpp"

namespace kreda::shadows {

/// How a light shines, as far as its shadows care.
enum class LightKind { directional, point, spot };

/// A light as its shadows see it: where it is and where it shines, not how bright.
struct ShadowLight {
    LightKind kind = LightKind::directional;  ///< decides which fields count
    glm::vec3 direction{0.0f, -1.0f, 0.0f};   ///< directional, spot: unit, the way the light travels, world space
    glm::vec3 position{0.0f};                 ///< point, spot: world space
    float outer_cone_deg = 30.0f;             ///< spot: half-angle beyond which there is no light, in (0, 180]
};

/// The triangles of one casting object, hidden parts left out. Owned by the frame, which outlives every method.
struct Occluder {
    std::span<const glm::vec3> positions;    ///< world space; may hold vertices that no triangle uses
    std::span<const std::uint32_t> indices;  ///< three a triangle, each < positions.size()
    bool clockwise = false;                  ///< mirrored: its triangles are clockwise seen from outside
};

/// How shadows are found.
enum class ShadowMethod { map, planar, volume, irregular, exact };
/// Does the method answer for all visible samples of a frame at once, instead of point by point? See below.
inline bool is_frame_by_frame(ShadowMethod method) {
    return method == ShadowMethod::planar || method == ShadowMethod::volume || method == ShadowMethod::irregular;
}

/// map: how its edges are softened (docs/62_pcf.md, docs/63_soft_shadows.md).
enum class ShadowFilter { none, pcf, pcss };
/// map: what keeps a surface from shadowing itself (docs/61_acne_and_bias.md).
enum class ShadowBias { none, constant, slope, normal_offset };

/// The [shadow] table of a scene.
struct ShadowSettings {
    ShadowMethod method = ShadowMethod::map;   ///< how shadows are found
    int size = 1024;                           ///< map: texels a side
    ShadowFilter filter = ShadowFilter::none;  ///< map
    int radius = 1;                            ///< pcf: (2 radius + 1)^2 texels
    float light_size = 0.2f;  ///< pcss: the light's width; directional: at distance 1 (tangent of its angle)
    ShadowBias bias = ShadowBias::slope;             ///< map
    float constant_bias = 0.0005f;                   ///< in the map's depth, 0..1
    float slope_bias = 2.0f;                         ///< times the least bias that a flat receiver needs
    raster::CullMode cull = raster::CullMode::none;  ///< which side of a triangle casts nothing
};

/// A method answers in one of two shapes.
///
/// Point by point (map, exact): something prepared once a frame from the occluders and the light, and a function over a
/// batch of points that fills a channel:
///
///     void shadow_factors(const ShadowMap& map, const raster::Channel3& position, const raster::Channel3& n,
///                         int count, raster::Channel& shadow);
///
/// Position in world space, n the unit normal, shadow 1 lit .. 0 in shadow. It reads and writes lanes_for(count)
/// entries. Such a method serves pixels, vertices and centroids alike.
///
/// Frame by frame (planar, volume, irregular): a function of all visible samples at once, before anything is shaded:
///
///     void irregular_shadow(std::span<const Occluder> occluders, const ShadowLight& light,
///                           const VisibleSamples& samples, std::span<float> shadow);
///
/// It fills one factor for every sample of the viewport; what it writes where nothing is seen is not read. A planar
/// shadow takes its plane besides, and treats every sample as if it lay on the plane: the scene reads the answer only
/// where the receiving object is seen.

/// What the camera sees, sample by sample, row 0 on top: viewport.width * viewport.height entries each.
struct VisibleSamples {
    raster::Viewport viewport;            ///< the sample grid
    glm::mat4 clip_from_world{1.0f};      ///< the camera's
    std::span<const float> depth;         ///< window depth as rasterized, raster::kClearDepth where nothing is seen
    std::span<const glm::vec3> position;  ///< world space; holds nothing where nothing is seen
};

}  // namespace kreda::shadows
