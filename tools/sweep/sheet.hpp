// A table of pictures with a heading for each column and row.
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "raster/image.hpp"

namespace kreda::tools {

struct Sheet {
    std::string column_key, row_key;         ///< empty: there is one column, one row
    std::vector<std::string> columns, rows;  ///< a heading each; at least one, which may be empty
    std::vector<raster::Image> pictures;     ///< row by row, encoded for a PNG, three channels, all of one size
    std::vector<std::string> remarks;        ///< a line under each picture; empty: none
};

/// The size of the pictures that fill a sheet of this size; `aspect` is their width over their height.
[[nodiscard]] glm::ivec2 sheet_picture_size(const Sheet& sheet, glm::ivec2 sheet_size, float aspect);

/// The sheet, as large as its pictures and headings require; encoded, three channels.
[[nodiscard]] raster::Image draw_sheet(const Sheet& sheet);

}  // namespace kreda::tools
