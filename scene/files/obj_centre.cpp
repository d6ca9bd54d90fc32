#include "scene/files/obj_centre.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace kreda::scene {

namespace {

/// The middle and the radius of the box around the positions that a face uses.
struct Extent {
    glm::dvec3 middle{0.0};
    double radius = 0.0;
};

template <class Position>
Extent extent_of(const std::vector<Position>& positions, const std::vector<ObjCorner>& corners) {
    if (corners.empty()) return {};
    glm::dvec3 least(std::numeric_limits<double>::max()), greatest = -least;
    for (const ObjCorner& corner : corners) {
        const glm::dvec3 p(positions[static_cast<std::size_t>(corner.position)]);
        least = glm::min(least, p);
        greatest = glm::max(greatest, p);
    }
    return {0.5 * least + 0.5 * greatest, glm::length(0.5 * greatest - 0.5 * least)};
}

bool is_far(const Extent& extent) {
    const glm::dvec3 m = glm::abs(extent.middle);
    return std::max({m.x, m.y, m.z}) > kFarFromZero * extent.radius;
}

bool is_ordinary_size(const Extent& extent) {
    return extent.radius >= 1.0 / kOrdinaryRadius && extent.radius <= kOrdinaryRadius;
}

/// Rounded to the power of two at or below.
double power_of_two(double x) {
    return std::exp2(std::floor(std::log2(x)));
}

}  // namespace

MeshFrame keep_about_centre(const ObjScan& scan, std::vector<glm::vec3>& positions) {
    positions.assign(scan.positions.begin(), scan.positions.end());
    const Extent rough = extent_of(positions, scan.corners);
    if (!is_far(rough) && is_ordinary_size(rough)) return {};
    const Extent extent = extent_of(scan.positions, scan.corners);
    if (!(extent.radius > 0.0)) return {};
    MeshFrame frame;
    if (!is_ordinary_size(extent)) frame.unit = power_of_two(extent.radius);
    if (is_far(extent)) {
        const double step = power_of_two(extent.radius) / 256.0;  // a round number reads better
        frame.origin = glm::round(extent.middle / step) * step;
    }
    for (std::size_t i = 0; i < positions.size(); ++i) {
        positions[i] = glm::vec3((scan.positions[i] - frame.origin) / frame.unit);
    }
    return frame;
}

}  // namespace kreda::scene
