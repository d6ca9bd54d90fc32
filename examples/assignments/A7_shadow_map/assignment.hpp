// A7: what is given. The functions at the end are yours to write, in student.cpp.
#pragma once

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

/// The picture that a directional light sees.
struct LightCamera {
    glm::vec3 right, up, backward;  ///< its axes, unit, world space; light travels along -backward
    glm::vec3 origin;               ///< a point of the plane of distance 0, the middle of the picture; world space
    glm::vec2 texel;                ///< width and height of a texel, world units
    float constant_bias;            ///< world units
    float slope_bias;               ///< times least_bias
};

/// Where a point lies in that picture.
struct Place {
    float u, v;      ///< texels, from the picture's left and TOP; the first texel's middle is (0.5, 0.5)
    float distance;  ///< from the plane of distance 0, along the light's way, world units
};

/// The distances that the light saw, row by row from the top.
struct ShadowMap {
    int size;  ///< texels a side
    std::vector<float> distance;
};

glm::vec3 light_space(const LightCamera& camera, const glm::vec3& p);
Place map_place(const LightCamera& camera, const glm::vec3& q, int size);
float least_bias(const glm::vec3& n_view, const glm::vec2& texel);
float is_lit(const ShadowMap& map, int column, int row, float distance);
float pcf(const ShadowMap& map, const Place& place, int radius);
float shadow_factor(const LightCamera& camera, const ShadowMap& map, const glm::vec3& p, const glm::vec3& n,
                    int radius);
