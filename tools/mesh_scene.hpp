// A mesh file without a scene: a scene around it, so that one command makes a picture of any OBJ or glTF file.
#pragma once

#include <string>

#include "scene/files/mesh_file.hpp"
#include "scene/files/read_scene.hpp"

namespace kreda::tools {

/// Is this the name of a mesh file rather than of a scene file?
[[nodiscard]] bool is_mesh_file(const std::string& path);

/// The text of a scene that shows the mesh. Where the file brings cameras, the first is used; otherwise the camera
/// stands in front of the mesh, a little above and to the right, and sees all of it. Where the file brings lights,
/// these shine; otherwise one from above the left shoulder and a dim one from the other side, and microfacet materials
/// stand in the light of a studio. Throws UserError for a mesh that cannot be shown.
[[nodiscard]] std::string scene_around_mesh(const std::string& path, const scene::LoadedMesh& loaded);

/// That scene itself, with the changes that `read` asks for. The file is read once.
[[nodiscard]] scene::Scene read_scene_around_mesh(const std::string& path, const scene::ReadOptions& read);

}  // namespace kreda::tools
