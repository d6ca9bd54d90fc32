// Built-in meshes: surfaces given by a formula, sampled on a grid of (u, v) and cut into triangles.
//
// What holds for all of them: y is up, triangles are counter-clockwise seen from outside, normals are analytic and
// unit, uvs fill 0..1 and are not mirrored (dP/du x dP/dv points outside), all is computed in double and rounded once.
// Where a texture starts over (the seam of a sphere), the vertices are there twice, with bitwise equal positions.
// `detail` outside the range of the shape throws std::invalid_argument with the shape, the value and the range.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "raster/mesh.hpp"

namespace kreda::raster {

/// The cube [-1, 1]^3 with flat faces; detail x detail quads a face, each face has its own vertices and 0..1 uvs.
[[nodiscard]] Mesh make_cube(int detail);

/// The unit ball: detail segments around y (segment 0 looks along +z), floor(detail / 2) rings from pole to pole,
/// 2 segments (rings - 1) triangles.
[[nodiscard]] Mesh make_sphere(int detail);

/// The torus around y with radii 1 (of the ring) and 0.4 (of the tube): detail x floor(detail / 2) quads.
[[nodiscard]] Mesh make_torus(int detail);

/// A tube of radius 0.2 around the (2,3) torus knot on the torus with radii 1 and 0.4: detail quads along the knot,
/// floor(detail / 8) around the tube.
[[nodiscard]] Mesh make_torus_knot(int detail);

/// The square [-1, 1]^2 of the xz plane, normal +y: detail x detail quads. It is open: it has no inside.
[[nodiscard]] Mesh make_plane(int detail);

/// y = 0.15 sin(7x) cos(5z) over [-1, 1]^2: detail x detail quads. It is open too.
[[nodiscard]] Mesh make_terrain(int detail);

/// The Utah teapot (Newell 1975): 32 bicubic patches of detail x detail quads, 64 detail^2 - 8 detail triangles.
/// Height 1, base on y = 0, the axis of the body is the y axis, spout towards +x: x in [-0.952, 1.090], |z| <= 0.635.
/// Parts: bottom, body, rim, lid, handle, spout. As in the original, handle and spout are open tubes whose ends hide
/// inside the body, and lid and rim have free edges: the teapot is not a closed surface.
[[nodiscard]] Mesh make_teapot(int detail);

/// The built-in mesh of that name, or nothing if there is none.
[[nodiscard]] std::optional<Mesh> make_shape(std::string_view name, int detail);

/// All names make_shape knows.
[[nodiscard]] std::span<const std::string_view> shape_names();

/// The detail that looks smooth at a few hundred pixels, or nothing if there is no such shape.
[[nodiscard]] std::optional<int> default_detail(std::string_view name);

}  // namespace kreda::raster
