// Triangles that are in a mesh more than once.
#pragma once

#include <cstddef>
#include <string>

#include "raster/mesh.hpp"

namespace kreda::scene {

/// Leaves out each triangle that has the same three vertices, the same way round, as one before it: it lies behind that
/// one everywhere, and costs as much. Thousands of them on one place would otherwise fill every pixel and stop every
/// shadow ray thousands of times. Returns how many were left out. No vertex belongs to two parts.
std::size_t drop_repeated_triangles(raster::Mesh& mesh);

/// What is said of them; "" of none.
[[nodiscard]] std::string warning_of_repeated(std::size_t triangles, const std::string& file);

}  // namespace kreda::scene
