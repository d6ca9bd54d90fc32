// Wavefront OBJ and MTL files, checked.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lighting/material.hpp"
#include "raster/mesh.hpp"
#include "scene/files/file_state.hpp"
#include "scene/scene.hpp"

namespace kreda::scene {

/// A mesh and the materials that its MTL files define. MeshPart::material indexes `materials`.
struct LoadedMesh {
    raster::Mesh mesh;
    std::vector<lighting::Material> materials;
    std::vector<std::string> warnings;  ///< what was wrong but not fatal, a line each, with its place
    std::vector<UsedFile> other_files;  ///< that were looked at beside the OBJ: MTL files, images that must be there
};

struct MeshFileOptions {
    Normals normals = Normals::file;             ///< file: the file's own, smooth ones where it has none
    bool allow_outside = false;                  ///< paths inside the OBJ and MTL may leave the OBJ's folder
    std::optional<float> crease = std::nullopt;  ///< degrees; none: by smoothing groups, else 60 and no specks
};

/// What a file is that is neither OBJ nor a scene, by its name: "is a PLY mesh; ..." with what can be read and how to
/// convert it. "" for all other names.
[[nodiscard]] std::string other_format(const std::string& path);

/// Load PATH (OBJ). Throws UserError with file and, where known, line and column.
[[nodiscard]] LoadedMesh load_mesh_file(const std::string& path, const MeshFileOptions& options = {});

}  // namespace kreda::scene
