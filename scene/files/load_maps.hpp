// Textures from files: decoded once for what their map means, shared by all maps of the same file.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lighting/batch/maps.hpp"
#include "raster/texture.hpp"
#include "scene/scene.hpp"

namespace kreda::scene {

struct LoadedFiles;

/// Load an image as a map: color as linear light (8 or 16 bits are sRGB unless the file says else, floats linear
/// already), value the red or grey channel, normal from 0..1 to -1..1 (lighting::normal_component). Grey files give
/// three equal channels where three are needed; alpha is left out, colours are not multiplied by it. Channels of other
/// names are a warning, and so is what was done to an image (turned upright, divided by its exposure). Colours and
/// values outside 0..1 are clamped and what is not finite becomes 0, with a warning. Throws UserError.
[[nodiscard]] std::shared_ptr<const raster::Texture> load_texture(const std::string& path, lighting::MapKind kind,
                                                                  bool with_pyramid,
                                                                  std::vector<std::string>& warnings);

/// Load the maps that these materials (by number) read, each file once and several side by side, and give meshes the
/// tangents that normal maps need. Other files are not touched. Texels that are there already stay. After
/// drop_maps_without_uv(). files: what is kept, or nullptr. Warnings go to scene.warnings. Throws UserError.
void load_maps(Scene& scene, const std::vector<bool>& materials, LoadedFiles* files = nullptr);

}  // namespace kreda::scene
