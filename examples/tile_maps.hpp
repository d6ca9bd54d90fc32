// The maps of 44_materials, made by a formula: tiles of gold and of blue glaze in grooves of dry mortar.
#pragma once

#include <array>
#include <string_view>

#include "raster/image.hpp"

namespace kreda::examples {

/// One map as its file holds it: values 0..1, colours encoded as sRGB, normals as (127 n + 128) / 255.
struct TileMap {
    std::string_view name;  ///< "albedo": the file is albedo.png
    raster::Image stored;
};

/// albedo, metallic, roughness, ao, normal: side x side texels that hold 2 x 2 tiles and go on where they end.
[[nodiscard]] std::array<TileMap, 5> tile_maps(int side);

}  // namespace kreda::examples
