// Shadow volumes: a sample lies in shadow if it lies inside the space that an occluder hides from the light. Count,
// behind every visible sample, how often a ray from the camera leaves a volume, less how often it enters one. Crow
// 1977; counting behind ("z-fail") instead of before the sample is right with the camera in the shadow too: Bilodeau &
// Songy 1999, Carmack 2000.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>

#include "raster/vertex_stage.hpp"
#include "shadows/projected_triangles.hpp"
#include "shadows/shadow.hpp"

namespace kreda::shadows {

/// An occluder, and its vertices in clip space as the picture's rasterizer had them: then a cap covers the same samples
/// at the same depths as the surface that it lies on, to the last bit.
struct VolumeCaster {
    Occluder occluder;                     ///< world space
    std::vector<glm::vec4> position_clip;  ///< one a position
};

/// clip_from_world * world_from_object * position, rounded as raster::transform_vertices does.
[[nodiscard]] std::vector<glm::vec4> clip_positions(const raster::MeshInstance& instance,
                                                    const glm::mat4& clip_from_world);

/// A face of a volume on the sample grid.
struct VolumeFace {
    ProjectedTriangle triangle;  ///< clipped, on the sample grid
    bool is_entry = true;        ///< the camera looks at its outside: a ray enters the volume here
    int weight = 1;              ///< how many volumes it bounds
};

/// All faces of a frame's volumes.
struct VolumeFaces {
    std::vector<VolumeFace> faces;            ///< of all casters
    std::uint32_t caps = 0, sides = 0;        ///< of all shapes, before anything is clipped or left out
    std::vector<std::uint32_t> open_casters;  ///< casters that are not closed: every triangle casts a volume of its own
};

/// A corner pushed away from the light L so far that nothing visible lies behind it:  a' = (L_w + e) a - L, e = 2^-30.
/// With e = 0 it is the point at infinity (Everitt & Kilgard 2002); a little less works for orthographic cameras too,
/// whose rays may run along the light and would meet no face at infinity.
[[nodiscard]] glm::vec4 pushed_away(const glm::dvec4& light, const glm::vec3& a);

/// All faces of the casters' volumes, on the sample grid.
[[nodiscard]] VolumeFaces make_volume_faces(std::span<const VolumeCaster> casters, const ShadowLight& light,
                                            const VisibleSamples& samples);

/// For every sample: in how many volumes it lies. A sample on the border of a volume is not in it: it is before an
/// entry, and behind an exit, at the same depth. 32 bits: no number of volumes wraps.
[[nodiscard]] std::vector<std::int32_t> count_volumes(const VolumeFaces& faces, const VisibleSamples& samples);

/// Does a face at depth z count for a sample that is seen at depth `seen`?
inline bool counts_behind(float z, float seen, bool is_entry) {
    return (z > seen) | ((z == seen) & is_entry);
}

/// The factor of a sample that lies in so many volumes.
inline float volume_factor(std::int32_t count) {
    return count > 0 ? 0.0f : 1.0f;
}

/// A face of a volume that lies over one sample.
struct FaceCrossing {
    float depth = 0.0f;      ///< window depth
    bool is_entry = true;    ///< a ray from the camera enters the volume here, else it leaves
    int weight = 1;          ///< how many volumes it bounds
    bool is_behind = false;  ///< behind what is seen: it counts
};

/// For explanations: every face over sample (x, y), in the order of the list. The count is that of the exits behind
/// less that of the entries behind.
[[nodiscard]] std::vector<FaceCrossing> faces_over(const VolumeFaces& faces, const VisibleSamples& samples, int x,
                                                   int y);

/// Bytes that volume_shadow takes while it runs, at most: a counter a sample, and of closed casters the corners twice
/// in clip space and two faces a triangle, with as many again for sides and what the clipper adds.
[[nodiscard]] std::size_t bytes_to_count_volumes(std::size_t samples, std::size_t vertices, std::size_t triangles);

/// One factor for every visible sample: 1 where the count is 0, else 0. Returns the casters that are not closed.
std::vector<std::uint32_t> volume_shadow(std::span<const VolumeCaster> casters, const ShadowLight& light,
                                         const VisibleSamples& samples, std::span<float> shadow);

}  // namespace kreda::shadows
