// The files that a scene is made of, as the page of `kreda view` carries them.
#pragma once

#include <string>
#include <vector>

#include "scene/files/loaded_files.hpp"
#include "scene/scene.hpp"

namespace kreda::tools {

struct CarriedFile {
    std::string name;  ///< in the page's own file system, relative to its root, or absolute
    std::string path;  ///< on this disk
};

struct CarriedScene {
    std::string path;    ///< of the scene or mesh, relative to `folder`; empty: the built-in scene
    std::string folder;  ///< where relative paths start in the page's file system
    std::vector<CarriedFile> files;
};

/// Meshes, their materials, maps and the environment of a scene that was read from `path` (a scene file or a mesh;
/// empty: built in) with this store, which knows what else was looked at. Relative paths in the files lead to the same
/// files in the page; names of folders above the scene's are not told unless a file says them. Throws UserError for an
/// image that the page cannot read.
[[nodiscard]] CarriedScene files_of_scene(const scene::Scene& scene, const std::string& path,
                                          const scene::LoadedFiles& loaded);

}  // namespace kreda::tools
