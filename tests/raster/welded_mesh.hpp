// What an OBJ without vn and vt gives of a shape.
#pragma once

#include <cstdint>
#include <vector>

#include "raster/mesh_checks.hpp"

namespace kreda::raster {

/// The mesh with one vertex a point and positions only.
inline Mesh welded(const Mesh& mesh) {
    const std::vector<std::uint32_t> points = weld_by_position(mesh.positions);
    Mesh result;
    result.parts = mesh.parts;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i] == result.positions.size()) result.positions.push_back(mesh.positions[i]);
    }
    for (const std::uint32_t vertex : mesh.indices) result.indices.push_back(points[vertex]);
    return result;
}

}  // namespace kreda::raster
