// live: A6 cook_torrance
// The specular part of equation (1) is D V F, and V is G / (4 (n . l) (n .
// v)). Here G stands without the denominator: the highlights are wrong most of
// all at grazing angles. Divide by it. The other functions are given.
#include "assignment.hpp"

glm::vec3 cook_torrance(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const Material& m) {
    const float n_dot_l = glm::dot(n, l);
    if (n_dot_l <= 0.0f) return glm::vec3(0.0f);
    const glm::vec3 h = glm::normalize(l + v);
    const float n_dot_v = glm::max(glm::dot(n, v), 0.0001f);
    const float n_dot_h = glm::max(glm::dot(n, h), 0.0f);
    const float v_dot_h = glm::max(glm::dot(v, h), 0.0f);
    const float D = ggx(n_dot_h, m.roughness);
    const float G = geometry(n_dot_l, n_dot_v, m.roughness);
    const glm::vec3 F = schlick(base_reflectivity(m.albedo, m.metallic), v_dot_h);
    const glm::vec3 diffuse = (1.0f - F) * (1.0f - m.metallic) * m.albedo / kPi;
    const glm::vec3 specular = D * G * F;
    return (diffuse + specular) * n_dot_l;
}
