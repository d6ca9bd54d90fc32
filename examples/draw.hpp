// The names of scene/draw.hpp, as the examples use them.
#pragma once

#include "scene/draw.hpp"

namespace kreda::examples {

using raster::Image;
using scene::crop, scene::enlarge, scene::enlarge_with_grid, scene::fit, scene::grey_image, scene::make_board,
    scene::montage, scene::panel_size, scene::paste;
using scene::draw_caption, scene::draw_disc, scene::draw_line, scene::draw_text, scene::draw_triangle_outline,
    scene::fill_rectangle, scene::fill_triangle, scene::text_scale;
using scene::kBlue, scene::kBoard, scene::kChalk, scene::kDust, scene::kGreen, scene::kOrange, scene::kRed,
    scene::kSlate, scene::kYellow;
using scene::signed_color, scene::srgb;

}  // namespace kreda::examples
