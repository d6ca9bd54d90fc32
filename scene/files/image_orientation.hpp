// Which way up an image lies in its file.
#pragma once

#include <string_view>

#include "raster/image.hpp"

namespace kreda::scene {

/// The picture as it is meant, top row first. `orientation` as EXIF counts (tag 274), where the first row and the first
/// column of the file are: 1 top left, 2 top right, 3 bottom right, 4 bottom left, 5 left top, 6 right top,
/// 7 right bottom, 8 left bottom. 5 to 8 exchange width and height. Other numbers mean 1.
[[nodiscard]] raster::Image upright(raster::Image stored, int orientation);

/// The orientation that EXIF data (a TIFF header and its directory) tell: 1 to 8; 1 where they tell none.
[[nodiscard]] int exif_orientation(std::string_view exif);

}  // namespace kreda::scene
