// From corners of triangles, each three indices, to vertices with one.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "raster/mesh.hpp"
#include "scene/files/obj_scan.hpp"

namespace kreda::scene {

/// What an OBJ text gives a mesh: its arrays, the positions about the mesh's centre.
struct MeshArrays {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec2> uvs;
    std::vector<glm::vec3> normals;
};

struct CornerTriangles {
    std::vector<ObjCorner> corners;               ///< three a triangle
    std::vector<std::uint32_t> smoothing_groups;  ///< one a triangle
    std::vector<raster::MeshPart> parts;
};

/// One vertex for each different corner of a part, in the order of first use; what no triangle uses is left out. No
/// vertex belongs to two parts, because parts differ in their material: Gouraud lights each vertex with one.
[[nodiscard]] raster::Mesh share_vertices(const MeshArrays& arrays, const CornerTriangles& triangles);

}  // namespace kreda::scene
