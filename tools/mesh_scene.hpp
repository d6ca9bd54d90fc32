// A mesh file without a scene: a scene around it, so that one command makes a picture of any OBJ.
#pragma once

#include <string>

#include "raster/mesh.hpp"
#include "scene/files/read_scene.hpp"

namespace kreda::tools {

/// Is this the name of a mesh file rather than of a scene file?
[[nodiscard]] bool is_mesh_file(const std::string& path);

/// The text of a scene that shows the whole mesh: the camera in front of it, a little above and to the right, one light
/// from above the left shoulder and a dim one from the other side. Throws UserError for a mesh that cannot be read.
[[nodiscard]] std::string scene_around_mesh(const std::string& path, const raster::Mesh& mesh);

/// That scene itself, with the changes that `read` asks for. The file is read once.
[[nodiscard]] scene::Scene read_scene_around_mesh(const std::string& path, const scene::ReadOptions& read);

}  // namespace kreda::tools
