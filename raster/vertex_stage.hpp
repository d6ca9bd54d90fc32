// The vertex stage: object space -> world space and screen, one loop over the vertices of each mesh.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "raster/aligned_vector.hpp"
#include "raster/mesh.hpp"
#include "raster/screen.hpp"

namespace kreda::raster {

/// One mesh placed in the world, with a material for each of its parts.
struct MeshInstance {
    const Mesh* mesh = nullptr;                ///< object space; not owned, never null where it is drawn
    glm::mat4 world_from_object{1.0f};         ///< where it stands
    std::vector<std::uint32_t> part_material;  ///< one a part
    std::vector<bool> part_hidden;             ///< one a part; empty: all are drawn
    std::uint32_t first_vertex = 0;            ///< where its vertices start in the streams
};

/// Which attributes the plan asks for; an attribute that nothing needs is neither computed nor stored.
struct VertexNeeds {
    bool position_world = false;  ///< for light, fog, shadows
    bool normal_world = false;    ///< for light
    bool uv = false;              ///< for maps
    bool tangent_world = false;   ///< for normal maps and anisotropic models
    bool color = false;           ///< lit per vertex: Gouraud
    bool color_behind = false;    ///< the same for the other side of the surface
    bool fog = false;             ///< fog factor per vertex
};

/// What is known of every vertex of every instance, one array an attribute. Arrays that are not needed are empty.
/// Vertices that the clipper made are appended behind those of the meshes.
struct VertexStreams {
    AlignedVector<ScreenVertex> screen;       ///< on the sample grid
    AlignedVector<glm::vec3> position_world;  ///< world space
    AlignedVector<glm::vec3> normal_world;    ///< not normalized
    AlignedVector<glm::vec2> uv;              ///< texture coordinates
    AlignedVector<glm::vec4> tangent_world;   ///< xyz not normalized, w the side of the bitangent; 0: the mesh has none
    AlignedVector<glm::vec3> color;           ///< linear RGB: lit at the vertices (Gouraud)
    AlignedVector<glm::vec3> color_behind;    ///< of the side that the normal points away from
    AlignedVector<float> fog;                 ///< f, 1 no fog .. 0 fog alone
};

/// Give every instance its place in the streams and size them. Returns the number of vertices.
std::uint32_t lay_out_vertices(std::vector<MeshInstance>& instances, const VertexNeeds& needs, VertexStreams& streams);

/// Does this transform mirror, so that counter-clockwise becomes clockwise? Its upper 3x3 has a negative determinant.
[[nodiscard]] bool is_mirrored(const glm::mat3& world_from_object);

/// The normal's matrix: inverse transpose of the upper 3x3, so that normals stay perpendicular under any scaling.
[[nodiscard]] glm::mat3 normal_from_object(const glm::mat4& world_from_object);

/// Transform all vertices of all instances into the streams (screen, and position, normal, uv, tangent as far as
/// needed).
void transform_vertices(const std::vector<MeshInstance>& instances, const glm::mat4& clip_from_world,
                        const Viewport& viewport, VertexStreams& streams);

}  // namespace kreda::raster
