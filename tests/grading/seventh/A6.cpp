// A6, by one who multiplies powers out and gives each part of the model a name.
#include "assignment.hpp"

namespace {

float positive(float x) {
    return x > 0.0f ? x : 0.0f;
}

float seen_from(float cosine, float k) {
    return cosine / (cosine + k * (1.0f - cosine));
}

}  // namespace

glm::vec3 base_reflectivity(const glm::vec3& albedo, float metallic) {
    const glm::vec3 plastic(0.04f);
    return plastic + metallic * (albedo - plastic);
}

glm::vec3 schlick(const glm::vec3& f0, float v_dot_h) {
    const float x = 1.0f - v_dot_h;
    const float x2 = x * x;
    const float rim = x2 * x2 * x;
    return f0 + rim * (glm::vec3(1.0f) - f0);
}

float ggx(float n_dot_h, float roughness) {
    const float alpha = roughness * roughness;
    const float c2 = n_dot_h * n_dot_h;
    const float below = c2 * alpha * alpha + (1.0f - c2);
    return alpha * alpha / (below * below) / kPi;
}

float geometry(float n_dot_l, float n_dot_v, float roughness) {
    const float one_more = 1.0f + roughness;
    const float k = 0.125f * one_more * one_more;
    return seen_from(n_dot_l, k) * seen_from(n_dot_v, k);
}

glm::vec3 cook_torrance(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const Material& m) {
    const float cos_l = glm::dot(l, n);
    glm::vec3 reflected(0.0f);
    if (cos_l > 0.0f) {
        const float cos_v = std::fmax(glm::dot(v, n), 0.0001f);
        const glm::vec3 h = glm::normalize(v + l);
        const glm::vec3 f0 = base_reflectivity(m.albedo, m.metallic);
        const glm::vec3 F = schlick(f0, positive(glm::dot(h, v)));
        const float D = ggx(positive(glm::dot(h, n)), m.roughness);
        const float G = geometry(cos_l, cos_v, m.roughness);
        const glm::vec3 glossy = F * (D * G / (4.0f * cos_v * cos_l));
        const glm::vec3 passed = (glm::vec3(1.0f) - F) * (1.0f - m.metallic);
        const glm::vec3 matt = passed * m.albedo * (1.0f / kPi);
        reflected = cos_l * (glossy + matt);
    }
    return reflected;
}

glm::vec3 shade(const glm::vec3& p, const glm::vec3& n, const glm::vec3& eye, const Material& m,
                const std::vector<Light>& lights) {
    const glm::vec3 normal = n / glm::length(n);
    const glm::vec3 to_eye = glm::normalize(eye - p);
    glm::vec3 color(0.0f);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const glm::vec3 share = cook_torrance(normal, lights[i].l, to_eye, m);
        color += share * lights[i].radiance;
    }
    return color;
}
