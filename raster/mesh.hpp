// A triangle mesh as plain data: shared vertices, three indices a triangle, parts with a name and a material.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace kreda::raster {

/// A run of triangles with one name and one material: an OBJ group or object, split where the material changes.
struct MeshPart {
    std::string name;                  ///< as its file has it; may be empty
    std::uint32_t first_triangle = 0;  ///< in the order of the indices
    std::uint32_t triangle_count = 0;  ///< triangles
    int material = -1;                 ///< index into the materials that came with the mesh file, -1: none
};

/// Triangles are counter-clockwise seen from outside. Every attribute array that is not empty has one entry a vertex.
/// A point of the file's is origin + unit * position: a float has 7 digits, and a mesh far from 0 needs them for its
/// shape.
struct Mesh {
    std::vector<glm::vec3> positions;  ///< object space, from the mesh's origin in its unit
    std::vector<glm::vec3> normals;    ///< object space, unit
    std::vector<glm::vec2> uvs;        ///< (0,0) lower left of the texture; empty: the mesh has none
    std::vector<glm::vec4>
        tangents;  ///< xyz unit, along growing u; w = +1, or -1 where uv is mirrored: make_tangents()
    std::vector<std::uint32_t> indices;  ///< three a triangle, each < positions.size()
    std::vector<MeshPart> parts;         ///< cover all triangles, in order
    glm::dvec3 origin{0.0};              ///< object space; not 0 for meshes far from it
    double unit = 1.0;                   ///< a power of two; not 1 for meshes that are tiny or huge

    /// Three indices a triangle.
    [[nodiscard]] std::uint32_t triangle_count() const {
        return static_cast<std::uint32_t>(indices.size() / 3);
    }
};

}  // namespace kreda::raster
