// MTL files: tinyobjloader reads them after a scan that checks the numbers and the paths.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "lighting/material.hpp"
#include "scene/files/named_file.hpp"

namespace kreda::scene {

/// The materials of all MTL files of a mesh. Where two have one name the first holds.
struct MtlMaterials {
    std::vector<lighting::Material> materials;
    std::unordered_map<std::string, int> index_of_name;
    std::vector<std::string> warnings;
};

/// Add the materials of one file. Ka Kd Ks Ke Ns become a blinn_phong material (lambert where Ks is absent or 0, or
/// illum is 1); Pr, Pm or a map of either makes it cook_torrance with albedo Kd. map_Bump is a height map where there
/// is no norm; its -bm multiplies MaterialMaps::bump_scale. map_Ke is multiplied by Ke, by 1 where that is absent or 0.
/// What is not given keeps lighting::Material's default.
void add_mtl(const ObjText& text, const NamedFileLimits& limits, MtlMaterials& into);

}  // namespace kreda::scene
