// A bounding volume hierarchy: which triangles can a ray to the light meet at all?
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "shadows/light_ray.hpp"

namespace kreda::shadows {

/// Box around a subtree. An inner node's children are nodes `first` and `first + 1`; a leaf (count > 0) holds the
/// triangles first .. first + count.
struct BvhNode {
    glm::vec3 low{0.0f};      ///< the box's least corner, world space
    std::uint32_t first = 0;  ///< node or triangle, see above
    glm::vec3 high{0.0f};     ///< the box's greatest corner
    std::uint32_t count = 0;  ///< triangles of a leaf; 0: an inner node
};

/// A tree of boxes over triangles, for rays.
struct Bvh {
    std::vector<BvhNode> nodes;       ///< nodes[0] is the root; empty without triangles
    std::vector<Triangle> triangles;  ///< in the order of the leaves
};

/// All triangles of the occluders whose corners are finite.
[[nodiscard]] std::vector<Triangle> gather_triangles(std::span<const Occluder> occluders);

/// Bytes that build_bvh takes while it runs, with the triangles that it is given.
[[nodiscard]] std::size_t bytes_to_build_bvh(std::size_t triangles);

/// Split by the surface area heuristic over bins.                                     Wald 2007
[[nodiscard]] Bvh build_bvh(std::vector<Triangle> triangles);

/// Is p shadowed by any triangle of the tree? Same answer as asking every triangle.
[[nodiscard]] bool any_shadow(const Bvh& bvh, const glm::dvec4& light, const glm::vec3& p);

/// From p to the place where the ray leaves the last triangle that shadows it, the one nearest to the light, world
/// units; 0: nothing shadows it. It is the one that a shadow map sees.
[[nodiscard]] double distance_to_last_blocker(const Bvh& bvh, const glm::dvec4& light, const glm::vec3& p);

/// The oracle of the tree: every triangle, one after another.
[[nodiscard]] bool any_shadow(std::span<const Triangle> triangles, const glm::dvec4& light, const glm::vec3& p);

}  // namespace kreda::shadows
