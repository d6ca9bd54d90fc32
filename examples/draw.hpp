// The names of tools/draw/draw.hpp, as the examples use them.
#pragma once

#include "tools/draw/draw.hpp"

namespace kreda::examples {

using raster::Image;
using tools::averaged, tools::box_average, tools::crop, tools::enlarge, tools::enlarge_with_grid, tools::fit,
    tools::grey_image, tools::make_board, tools::montage, tools::panel_corner, tools::panel_size, tools::paste;
using tools::draw_disc, tools::draw_line, tools::draw_text, tools::draw_triangle_outline, tools::fill_rectangle,
    tools::fill_triangle, tools::text_scale;
using tools::kBlue, tools::kBoard, tools::kChalk, tools::kDust, tools::kGreen, tools::kOrange, tools::kRed,
    tools::kSlate, tools::kYellow;
using tools::signed_color, tools::srgb;

}  // namespace kreda::examples
