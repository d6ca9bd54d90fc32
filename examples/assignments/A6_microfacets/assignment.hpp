// A6: what is given. The functions at the end are yours to write, in student.cpp.
#pragma once

#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

const float kPi = 3.14159265f;

struct Material {
    glm::vec3 albedo;  ///< c
    float metallic;    ///< 0 or 1, or between them
    float roughness;   ///< what an artist sets; alpha = roughness^2
};

/// A light from far away.
struct Light {
    glm::vec3 l;         ///< unit, to the light
    glm::vec3 radiance;  ///< linear RGB
};

glm::vec3 base_reflectivity(const glm::vec3& albedo, float metallic);
glm::vec3 schlick(const glm::vec3& f0, float v_dot_h);
float ggx(float n_dot_h, float roughness);
float geometry(float n_dot_l, float n_dot_v, float roughness);
glm::vec3 cook_torrance(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const Material& m);
glm::vec3 shade(const glm::vec3& p, const glm::vec3& n, const glm::vec3& eye, const Material& m,
                const std::vector<Light>& lights);
