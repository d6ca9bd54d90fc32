// Triangles that are in a mesh more than once.
#pragma once

#include <cstddef>
#include <string>

#include "raster/mesh.hpp"

namespace kreda::scene {

/// Leaves out each triangle whose corners are where those of one before it in its part are, the same way round: it lies
/// behind that one everywhere, and costs as much. Thousands of them on one place would otherwise fill every pixel and
/// stop every shadow ray thousands of times. Places are equal if all their bits are; normals and texture coordinates
/// are those of the first. Returns how many were left out. The parts hold all triangles, one part after the other.
std::size_t drop_repeated_triangles(raster::Mesh& mesh);

/// What is said of them; "" of none.
[[nodiscard]] std::string warning_of_repeated(std::size_t triangles, const std::string& file);

}  // namespace kreda::scene
