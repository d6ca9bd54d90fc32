// Triangles that are not part of the picture, on the picture's sample grid: the faces of shadow volumes, projected
// shadows. Same clipping, same snap, same fill rule as the rasterizer, but they count or mark samples instead of hiding
// each other.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

#include "raster/screen.hpp"

namespace kreda::shadows {

/// A triangle on the sample grid, clockwise with y down; corners in the order in which the rasterizer would hold them.
struct ProjectedTriangle {
    raster::ScreenVertex a, b, c;  ///< 1/256 sample
    bool is_front = true;          ///< counter-clockwise as it was given: the camera sees its front
};

/// Append what the picture sees of a triangle in clip space, as one triangle or, where it is clipped, as several. What
/// lies beyond the far plane is kept, with z > 1: whatever is seen is nearer. Where the rasterizer would draw the
/// triangle, its pieces and their depth planes are the rasterizer's to the last bit.
void append_on_screen(const glm::vec4& a, const glm::vec4& b, const glm::vec4& c, const raster::Viewport& viewport,
                      std::vector<ProjectedTriangle>& triangles);

/// The samples of a row that the triangle covers: first .. last, none if first > last. Exact, the same as asking
/// raster::covers_sample for each.
struct SampleSpan {
    int first = 0, last = -1;  ///< columns, both included
};
/// First and last sample of row y that the triangle covers.
[[nodiscard]] SampleSpan covered_in_row(const ProjectedTriangle& triangle, int y, int width);

}  // namespace kreda::shadows
