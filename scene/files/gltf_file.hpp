// glTF 2.0 scenes, .gltf and .glb, as a mesh with materials, and the cameras and lights that stand in them.
#pragma once

#include <string>

#include "scene/files/mesh_file.hpp"

namespace kreda::scene {

/// Load all meshes of a file's scene as one, each where its nodes place it: a part for each primitive, called after its
/// node or mesh. A damaged primitive is left out with a warning as long as others remain; everything that is not
/// modelled is named in one warning. Skinned meshes and morph targets are drawn as they are stored. Throws UserError.
[[nodiscard]] LoadedMesh load_gltf_file(const std::string& path, const MeshFileOptions& options);

}  // namespace kreda::scene
