// Which map a file's name announces: the habits of texture libraries and of the tools that export textures.
#pragma once

#include <string>

namespace kreda::scene {

/// "albedo", "emission", "metallic", "roughness", "ao", "normal", "normal_down" (green points down), or "" for none.
/// The last word counts, in any case: words end at _ - . and blanks, and where a capital follows a small letter. What
/// libraries put behind it is skipped: sizes (1K, 2048), tiles (1001), variants, "map". Metal007_1K_Color.jpg is an
/// albedo, and so are rockBaseColor2.png and Albedo_4K__abc.jpg.
[[nodiscard]] std::string map_announced_by(const std::string& file_name);

/// The words that announce the maps, for a message: "albedo (or basecolor), ...".
[[nodiscard]] std::string announcing_words();

}  // namespace kreda::scene
