// A3: what is given. The functions at the end are yours to write, in student.cpp.
#pragma once

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

/// Light that falls off with distance d: 1 / (constant + linear d + quadratic d^2).
struct Attenuation {
    float constant = 1.0f, linear = 0.0f, quadratic = 0.0f;
};

enum class LightType { directional, point, spot };

struct Light {
    LightType type = LightType::directional;
    glm::vec3 position{0.0f};  ///< point, spot: world space
    glm::vec3 axis{0.0f};      ///< directional, spot: unit, the way the light travels, world space
    glm::vec3 radiance{1.0f};  ///< color x intensity, linear RGB
    Attenuation attenuation;   ///< point, spot
    float cos_inner = 1.0f;    ///< spot: full light inside the cone of this cosine
    float cos_outer = 0.0f;    ///< spot: no light outside the cone of this cosine
};

/// What a light sends to one point of a surface.
struct LightSample {
    glm::vec3 l;           ///< unit, surface -> light
    glm::vec3 irradiance;  ///< radiance x attenuation x cone
};

struct Material {
    glm::vec3 ambient, diffuse, specular, emission;  ///< m_A, m_D, m_S, m_E
    float shininess;                                 ///< h, the exponent
};

/// What one light adds, before its colour.
struct Terms {
    glm::vec3 diffuse, specular;
};

/// Where a ray of sight meets a surface.
struct SurfacePoint {
    glm::vec3 position;  ///< world space
    glm::vec3 normal;    ///< world space, interpolated between the corners: NOT of unit length
    glm::vec3 eye;       ///< the camera's position
    Material material;
    glm::vec3 ambient_light;  ///< s_A
};

float attenuate(const Attenuation& a, float d);
float spot_cone(float cos_angle, float cos_inner, float cos_outer);
LightSample sample_light(const Light& light, const glm::vec3& p);
glm::vec3 mirror_vector(const glm::vec3& n, const glm::vec3& l);
Terms phong(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const Material& m);
glm::vec3 shade(const SurfacePoint& point, const std::vector<Light>& lights);
