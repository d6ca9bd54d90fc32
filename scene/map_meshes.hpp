// Gives meshes what maps need: texture coordinates are checked, tangents for normal maps are made.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace kreda::scene {

/// Whether some visible part of the scene has this material (an index into scene.materials).
[[nodiscard]] std::vector<bool> visible_materials(const Scene& scene);

/// Parts whose mesh has no texture coordinates are drawn without maps: they get a copy of their material that has
/// none. Warns once a mesh and material.
void drop_maps_without_uv(Scene& scene);

/// A mesh with tangents, made from one without.
struct TangentMesh {
    std::shared_ptr<const raster::Mesh> from, mesh;
    std::uint32_t without_direction = 0;  ///< vertices
};
/// By the mesh without.
using TangentMeshes = std::map<const raster::Mesh*, TangentMesh>;

/// Gives the meshes whose material reads a normal map (its texels are there) their tangents: those of `made`, to which
/// it adds. Warns where some vertices have none.
void add_tangents(Scene& scene, TangentMeshes& made);

}  // namespace kreda::scene
