#include "raster/outside_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace kreda::raster {

namespace {

/// Rounding of the matrix product in float, as a share of the sum of the sizes of its terms.
constexpr double kRounding = 1e-5;

/// A plane of the view, dot(plane, clip) >= 0 inside, asked of points of the object.
struct ObjectPlane {
    glm::dvec4 plane{0.0};  ///< what it is in the object's space
    glm::dvec4 size{0.0};   ///< the sum of the sizes of the terms of each component
};

ObjectPlane plane_of_object(const glm::dvec4& plane, const glm::mat4& clip_from_world,
                            const glm::mat4& world_from_object) {
    const glm::dmat4 clip_from_object = glm::dmat4(clip_from_world) * glm::dmat4(world_from_object);
    ObjectPlane result;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            result.plane[column] += plane[row] * clip_from_object[column][row];
            for (int k = 0; k < 4; ++k) {
                result.size[column] +=
                    std::abs(plane[row] * double{clip_from_world[k][row]} * double{world_from_object[column][k]});
            }
        }
    }
    return result;
}

bool is_beyond(const ObjectPlane& plane, const glm::dvec3& p) {
    const glm::dvec4 point(p, 1.0);
    return glm::dot(plane.plane, point) < -kRounding * glm::dot(plane.size, glm::abs(point));
}

struct MeshBox {
    glm::vec3 least, greatest;
    bool is_finite = true;
};

MeshBox box_of(const Mesh& mesh) {
    MeshBox box{mesh.positions[0], mesh.positions[0]};
    glm::vec3 nothing(0.0f);  // stays 0 unless a coordinate is infinite or not a number
    for (const glm::vec3& p : mesh.positions) {
        box.least = glm::min(box.least, p);
        box.greatest = glm::max(box.greatest, p);
        nothing += 0.0f * p;
    }
    box.is_finite = nothing == glm::vec3(0.0f);
    return box;
}

}  // namespace

bool lies_outside(const MeshInstance& instance, const glm::mat4& clip_from_world, const Viewport& viewport) {
    const double guard_x = guard_band_ndc(viewport.width), guard_y = guard_band_ndc(viewport.height);
    const std::array<glm::dvec4, 6> planes = {glm::dvec4(0, 0, 1, 1),       glm::dvec4(0, 0, -1, 1),
                                              glm::dvec4(1, 0, 0, guard_x), glm::dvec4(-1, 0, 0, guard_x),
                                              glm::dvec4(0, 1, 0, guard_y), glm::dvec4(0, -1, 0, guard_y)};
    const std::vector<glm::vec3>& positions = instance.mesh->positions;
    if (positions.empty()) return false;
    for (const glm::dvec4& plane : planes) {
        const ObjectPlane mine = plane_of_object(plane, clip_from_world, instance.world_from_object);
        if (!is_beyond(mine, positions.front())) continue;  // most objects are seen, and their first vertex says so
        const MeshBox box = box_of(*instance.mesh);
        bool all = box.is_finite;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec3 p{corner & 1 ? box.greatest.x : box.least.x, corner & 2 ? box.greatest.y : box.least.y,
                              corner & 4 ? box.greatest.z : box.least.z};
            all = all && is_beyond(mine, p);
        }
        if (all) return true;
    }
    return false;
}

}  // namespace kreda::raster
