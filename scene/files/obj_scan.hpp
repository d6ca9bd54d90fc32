// One pass over an OBJ text: its numbers, its polygons as written, its names, and what is odd about it. What other
// readers get wrong in silence becomes an error with its place.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/files/obj_text.hpp"

namespace kreda::scene {

/// One corner of a face: indices from 0 into the three arrays, -1: the file gives none.
struct ObjCorner {
    int position = -1;
    int uv = -1;
    int normal = -1;
    bool operator==(const ObjCorner&) const = default;
};

/// The faces from `first_face` on, until the next run, belong to this group or object and have this material.
struct ObjRun {
    std::string name;
    std::string material;
    std::size_t first_face = 0;
    bool operator==(const ObjRun&) const = default;
};

/// Where a face came from, its smoothing group (0: none), and the first of its corners.
struct ObjFace {
    std::uint32_t offset = 0;
    std::uint32_t smoothing_group = 0;
    std::uint32_t first_corner = 0;
    bool operator==(const ObjFace&) const = default;
};

/// A name that the text mentions: a material, an MTL file.
struct ObjName {
    std::string name;
    std::size_t offset = 0;
    bool operator==(const ObjName&) const = default;
};

/// What a text says. All indices are within their arrays.
struct ObjScan {
    std::vector<glm::dvec3> positions;  ///< as written: the nearest double
    std::vector<glm::vec2> uvs;
    std::vector<glm::vec3> normals;  ///< as written: perhaps not unit, perhaps 0
    std::vector<ObjCorner> corners;  ///< of all faces, one after another
    std::vector<ObjFace> faces;
    std::vector<ObjRun> runs;
    bool has_smoothing_groups = false;    ///< there is an `s` statement
    std::vector<ObjName> material_files;  ///< the rest of each `mtllib` line
    std::vector<ObjName> materials;       ///< first use of each name
    std::vector<std::string> warnings;
    bool operator==(const ObjScan&) const = default;
};

/// Faces of more corners are refused: ear clipping takes time with their square.
constexpr int kMaxPolygonCorners = 10000;

/// Throws UserError with line and column. A text is cut into `stretches` of whole lines that are scanned side by side;
/// 0: as many as there are threads, if it is long enough. The result does not depend on it.
[[nodiscard]] ObjScan scan_obj(const ObjText& text, int stretches = 0);

}  // namespace kreda::scene
