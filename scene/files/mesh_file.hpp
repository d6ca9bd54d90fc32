// Mesh files, checked: Wavefront OBJ with MTL, and glTF through tinygltf.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "lighting/light.hpp"
#include "lighting/material.hpp"
#include "raster/camera.hpp"
#include "raster/mesh.hpp"
#include "scene/files/file_state.hpp"
#include "scene/scene.hpp"

namespace kreda::scene {

/// A camera that stands in a mesh file (glTF). Places are the file's.
struct FileCamera {
    glm::dvec3 position{0.0};
    glm::dvec3 forward{0.0, 0.0, -1.0};  ///< unit, the way it looks
    glm::dvec3 up{0.0, 1.0, 0.0};        ///< unit
    raster::Projection projection = raster::Projection::perspective;
    double vertical_fov_deg = 45.0;  ///< perspective
    double height = 2.0;             ///< orthographic: from bottom to top
    double aspect = 0.0;             ///< width / height; 0: any
    double near = 0.0, far = 0.0;    ///< distances of the planes; far 0: none
};

/// A light that stands in a mesh file (glTF). `light.position` does not count.
struct FileLight {
    lighting::Light light;
    glm::dvec3 position{0.0};
};

/// A mesh and the materials that its file or its MTL files define. MeshPart::material indexes `materials`.
struct LoadedMesh {
    raster::Mesh mesh;
    std::vector<lighting::Material> materials;
    std::vector<std::string> warnings;  ///< what was wrong but not fatal, a line each, with its place
    std::vector<UsedFile> other_files;  ///< that were looked at beside the OBJ: MTL files, images that must be there
    std::vector<FileCamera> cameras;    ///< for who draws the file without a scene; a scene file has its own
    std::vector<FileLight> lights;      ///< the same
    bool two_sided = false;             ///< glTF: the back of some material is to be seen
};

struct MeshFileOptions {
    Normals normals = Normals::file;             ///< file: the file's own, smooth ones where it has none
    bool allow_outside = false;                  ///< paths inside the OBJ and MTL may leave the OBJ's folder
    std::optional<float> crease = std::nullopt;  ///< degrees; none: by smoothing groups, else 60 and no specks
};

/// What a file is that is neither OBJ, glTF nor a scene, by its name: "is a PLY mesh; ..." with what can be read and
/// how to convert it. "" for all other names.
[[nodiscard]] std::string other_format(const std::string& path);

/// Load PATH: .gltf and .glb as glTF, anything else as OBJ. Throws UserError with file and, where known, line and
/// column.
[[nodiscard]] LoadedMesh load_mesh_file(const std::string& path, const MeshFileOptions& options = {});

}  // namespace kreda::scene
