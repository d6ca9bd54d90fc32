// What tinyobjloader makes of a scanned OBJ text: its numbers, its polygons as written, its names.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/files/obj_scan.hpp"

namespace kreda::scene {

/// One corner of a face: indices from 0 into the three arrays, -1: the file gives none.
struct ObjCorner {
    int position = -1;
    int uv = -1;
    int normal = -1;
    bool operator==(const ObjCorner&) const = default;
};

/// The polygons from `first_polygon` on, until the next run, belong to this group or object and have this material.
struct ObjRun {
    std::string name;
    std::string material;
    std::size_t first_polygon = 0;
};

struct ObjPolygons {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec2> uvs;
    std::vector<glm::vec3> normals;         ///< as written: perhaps not unit, perhaps 0
    std::vector<ObjCorner> corners;         ///< those of polygon i: first_corner[i] .. first_corner[i + 1]
    std::vector<std::size_t> first_corner;  ///< one entry more than there are polygons
    std::vector<ObjRun> runs;
};

/// All indices are within their arrays: scan_obj has checked them.
[[nodiscard]] ObjPolygons read_polygons(const ObjText& text, const ObjScan& scan);

}  // namespace kreda::scene
