// One pass over an OBJ text before the library sees it: what the library would get wrong in silence becomes an error
// with its place, and what it cannot read (comments behind a face, continuations, mtllib with blanks) is made plain.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/files/obj_text.hpp"

namespace kreda::scene {

/// Where a face came from, and its smoothing group (0: none).
struct ObjFaceOrigin {
    std::uint32_t offset = 0;
    std::uint32_t smoothing_group = 0;
};

/// A name that the text mentions: a material, an MTL file.
struct ObjName {
    std::string name;
    std::size_t offset = 0;
};

struct ObjScan {
    std::string statements;  ///< v, vt, vn, f, usemtl, g and o alone, one a line, every number and index checked
    std::vector<ObjFaceOrigin> faces;     ///< one for each `f`, in order
    bool has_smoothing_groups = false;    ///< there is an `s` statement
    std::vector<ObjName> material_files;  ///< the rest of each `mtllib` line
    std::vector<ObjName> materials;       ///< first use of each name
    std::vector<std::string> warnings;
};

/// Faces of more corners are refused: ear clipping takes time with their square.
constexpr int kMaxPolygonCorners = 10000;

/// Throws UserError with line and column.
[[nodiscard]] ObjScan scan_obj(const ObjText& text);

}  // namespace kreda::scene
