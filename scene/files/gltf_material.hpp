// Materials of a glTF file: metallic and roughness of cook_torrance, or unlit, with their maps.
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "lighting/material.hpp"
#include "scene/files/gltf_left_out.hpp"
#include "scene/files/gltf_model.hpp"

namespace kreda::scene {

/// Which texture coordinates of the mesh a material reads, and what it makes of them (KHR_texture_transform).
struct GltfUv {
    int set = 0;  ///< TEXCOORD_0
    glm::dvec2 offset{0.0};
    glm::dvec2 scale{1.0};
    double rotation = 0.0;  ///< radians, counter-clockwise on a picture whose v grows downwards

    bool operator==(const GltfUv&) const = default;
};

/// Texture coordinates as Kreda has them, (0, 0) in the lower left corner, from those of the file, (0, 0) in the upper
/// left:    u' = c s_u u + s s_v v + o_u,   v' = 1 - (-s s_u u + c s_v v + o_v),   c, s: cosine and sine of the
/// rotation.
[[nodiscard]] glm::vec2 uv_of(const GltfUv& how, const glm::vec2& uv);

/// All materials of a file, by their numbers.
struct GltfMaterials {
    std::vector<lighting::Material> materials;
    std::vector<GltfUv> uv;       ///< of each
    std::vector<bool> two_sided;  ///< of each: doubleSided
    std::vector<std::string> warnings;
};

/// Factors multiply textures as the specification says: texels are multiplied when they are loaded. Metallic is a
/// texture's blue, roughness its green, ao the red of the occlusion texture. A texture that is read at other
/// coordinates than the material's first one is left out.                 glTF 2.0 specification, section 3.9
[[nodiscard]] GltfMaterials read_gltf_materials(const GltfFile& gltf, LeftOut& left_out);

}  // namespace kreda::scene
