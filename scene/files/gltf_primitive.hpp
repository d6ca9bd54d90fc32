// One primitive of a glTF mesh as triangles, in the mesh's own space.
#pragma once

#include "raster/mesh.hpp"
#include "scene/files/gltf_left_out.hpp"
#include "scene/files/gltf_material.hpp"
#include "scene/files/gltf_model.hpp"

namespace kreda::scene {

/// A primitive as a mesh of one part, with normals: where the file has none, or some without length, each triangle gets
/// its own. Tangents are the file's, or empty.
struct GltfPrimitive {
    raster::Mesh mesh;
    int material = -1;            ///< index into Model::materials, -1: none
    std::size_t bad_normals = 0;  ///< of no length
};

/// Triangles, strips and fans become triangles, counter-clockwise seen from outside; a triangle with a corner twice is
/// left out. Points and lines have none. Throws UserError for what does not fit together.
[[nodiscard]] GltfPrimitive read_gltf_primitive(const GltfFile& gltf, const tinygltf::Primitive& primitive,
                                                const GltfMaterials& materials, LeftOut& left_out);

}  // namespace kreda::scene
