// What the built-in meshes share: pushing a vertex, connecting a grid of vertices, checking `detail`.
#pragma once

#include <cstdint>
#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "raster/mesh.hpp"

namespace kreda::raster {

/// Appends one vertex, rounded to float here and nowhere else. The normal must be unit.
void append_vertex(Mesh& mesh, glm::dvec3 position, glm::dvec3 normal, glm::dvec2 uv);

/// Connects the (outer + 1) x (inner + 1) vertices that start at first_vertex (inner index fastest). The quad
///   a = (i, j)   b = (i + 1, j)   c = (i + 1, j + 1)   d = (i, j + 1)      becomes the triangles abc and acd,
/// so d(outer) x d(inner) must point outside. A triangle with two bitwise equal corners (at a pole) is left out.
void append_grid_triangles(Mesh& mesh, std::uint32_t first_vertex, int outer, int inner);

/// Makes the triangles after the last part a part of that name.
void close_part(Mesh& mesh, std::string_view name);

/// Throws std::invalid_argument unless the shape allows this detail.
void require_detail(std::string_view shape, int detail);

}  // namespace kreda::raster
