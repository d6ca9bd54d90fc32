// The tree of a glTF scene: where its nodes stand in the world.
#pragma once

#include <vector>

#include <glm/mat4x4.hpp>

#include "scene/files/gltf_model.hpp"

namespace kreda::scene {

/// A node and its place.
struct PlacedNode {
    int node = 0;  ///< index into Model::nodes
    glm::dmat4 world_from_node{1.0};
};

/// All nodes of the file's default scene (else its first; without scenes all trees), parents before children. A node's
/// transform is its matrix, or  T R S  from translation, rotation (a quaternion x, y, z, w) and scale; children stand
/// in their parent's space. Throws UserError at a node that stands in the tree twice, or whose transform is no affine
/// map.                                                                     glTF 2.0 specification, section 3.5
[[nodiscard]] std::vector<PlacedNode> place_nodes(const GltfFile& gltf);

}  // namespace kreda::scene
