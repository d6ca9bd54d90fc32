// A folder of maps as one material: which file is the albedo, which the normal map, told by their names.
#pragma once

#include <string>
#include <vector>

#include "lighting/material.hpp"

namespace kreda::scene {

/// What a pattern like "rusted_iron/*.png" found.
struct MapFolder {
    lighting::MaterialMaps maps;        ///< files only; normal_y from "NormalDX" and the like
    std::vector<std::string> not_used;  ///< names of files that match the pattern but are none of these maps
    std::string problem;                ///< empty: at least one map was found and none twice
};

/// Which map a file's name announces: "albedo", "emission", "metallic", "roughness", "ao", "normal", "normal_down"
/// (green points down), or "" for none. The last word counts, in any case; words end at _ - . and blanks, and sizes
/// (1K, 2048) are skipped: Metal007_1K_Color.jpg is an albedo.
[[nodiscard]] std::string map_announced_by(const std::string& file_name);

/// The words that announce the maps, for a message: "albedo (or basecolor, color, ...), ...".
[[nodiscard]] std::string announcing_words();

/// Files whose name matches the pattern's last part (* stands for anything) in its folder. A folder alone means all of
/// its files. Of two normal maps that differ in their green the one that points up is taken.
[[nodiscard]] MapFolder find_maps(const std::string& pattern);

}  // namespace kreda::scene
