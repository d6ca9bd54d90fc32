// Cameras and lights that stand in a glTF scene.
#pragma once

#include <vector>

#include "scene/files/gltf_left_out.hpp"
#include "scene/files/gltf_nodes.hpp"
#include "scene/files/mesh_file.hpp"

namespace kreda::scene {

/// The cameras, in the order of the nodes: they look along -z of their node, +y is up. One whose numbers make no
/// picture is left out with a warning.                                              glTF 2.0 specification,
/// section 3.10
[[nodiscard]] std::vector<FileCamera> read_gltf_cameras(const GltfFile& gltf, const std::vector<PlacedNode>& nodes,
                                                        std::vector<std::string>& warnings);

/// The lights of KHR_lights_punctual: they shine along -z of their node. 1 lux of a directional light is irradiance 1,
/// 1 candela of a point or spot light is irradiance 1 at distance 1, falling with 1 / d^2.
[[nodiscard]] std::vector<FileLight> read_gltf_lights(const GltfFile& gltf, const std::vector<PlacedNode>& nodes,
                                                      LeftOut& left_out, std::vector<std::string>& warnings);

}  // namespace kreda::scene
