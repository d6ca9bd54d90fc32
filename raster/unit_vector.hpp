// Lengths and unit vectors that stay finite where there is no direction.
#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace kreda::raster {

/// Squared length below which a vector counts as having none.
inline constexpr float kLeastLength2 = 1e-30f;

/// |v|, but at least sqrt(least_length2): a number to divide by.
inline float divisible_length(const glm::vec3& v, float least_length2 = kLeastLength2) {
    const float length2 = glm::dot(v, v);
    return std::sqrt(length2 > least_length2 ? length2 : least_length2);
}

/// v / |v|; a vector of length 0 stays 0. What is shorter than sqrt(least_length2) comes out shorter than 1.
inline glm::vec3 unit(const glm::vec3& v, float least_length2 = kLeastLength2) {
    return v * (1.0f / divisible_length(v, least_length2));
}

}  // namespace kreda::raster
