// A4: what is given. The functions at the end are yours to write, in student.cpp.
#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

enum class Frequency { flat, gouraud, phong };

/// A triangle in world space, counter-clockwise seen from outside.
struct Triangle {
    glm::vec3 a, b, c;        ///< its corners
    glm::vec3 n_a, n_b, n_c;  ///< the surface's normals there, of any length
};

/// How much of each corner a pixel shows: a = w.x a_a + w.y a_b + w.z a_c. They sum to 1.
using Weights = glm::vec3;

/// One directional light and a material.
struct Lit {
    glm::vec3 l, radiance, ambient_light;  ///< l: unit, to the light
    glm::vec3 eye;                         ///< world space
    glm::vec3 ambient, diffuse, specular;  ///< m_A, m_D, m_S
    float shininess;                       ///< h
};

/// Blinn and Phong's model at one point, done for you. n: of unit length.
inline glm::vec3 light_at(const Lit& lit, const glm::vec3& p, const glm::vec3& n) {
    const glm::vec3 v = glm::normalize(lit.eye - p);
    const float n_dot_l = glm::dot(n, lit.l);
    const float n_dot_h = glm::dot(n, glm::normalize(lit.l + v));
    const float cosine = n_dot_l > 0.0f ? n_dot_l : 0.0f;
    const float highlight = n_dot_l > 0.0f && n_dot_h > 0.0f ? std::pow(n_dot_h, lit.shininess) : 0.0f;
    return lit.ambient_light * lit.ambient + lit.radiance * (lit.diffuse * cosine + lit.specular * highlight);
}

glm::vec3 world_normal(const glm::mat4& world_from_object, const glm::vec3& n_object);
glm::vec3 face_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);
glm::vec3 flat_color(const Triangle& t, const Lit& lit);
glm::vec3 gouraud_color(const Triangle& t, const Weights& w, const Lit& lit);
glm::vec3 phong_color(const Triangle& t, const Weights& w, const Lit& lit);
glm::vec3 shade_pixel(Frequency frequency, const Triangle& t, const Weights& w, const Lit& lit);
