// A folder of maps as one material: which file is the albedo, which the normal map, told by their names.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "lighting/material.hpp"

namespace kreda::scene {

/// Two files of a folder that announce the same map.
struct TwoFiles {
    std::string map, first, second;
};

/// What a pattern like "rusted_iron/*.png" found.
struct MapFolder {
    lighting::MaterialMaps maps;        ///< files only; normal_y from "NormalDX" and the like
    std::vector<std::string> not_used;  ///< names of files that match the pattern but are none of these maps
    std::vector<TwoFiles> twice;        ///< maps that more than one file announces; none of them is in `maps`
    std::string problem;                ///< empty: at least one map was found
};

/// Files whose name matches the pattern's last part (* stands for anything) in its folder. A folder alone means all of
/// its files. Of two normal maps that differ in their green the one that points up is taken. What announces one of
/// `given` ("albedo", "normal", ...) is left out: those maps come from somewhere else.
[[nodiscard]] MapFolder find_maps(const std::string& pattern, const std::set<std::string>& given = {});

}  // namespace kreda::scene
