// A6, solved by another hand: glm::mix, powers by hand, cosines named by their vectors.
#include "assignment.hpp"

namespace {

float one_side(float cosine, float k) {
    return cosine / (k + cosine * (1.0f - k));
}

float cosine_of(const glm::vec3& a, const glm::vec3& b, float least) {
    return glm::max(glm::dot(a, b), least);
}

}  // namespace

glm::vec3 base_reflectivity(const glm::vec3& albedo, float metallic) {
    return glm::mix(glm::vec3(0.04f), albedo, metallic);
}

glm::vec3 schlick(const glm::vec3& f0, float v_dot_h) {
    const float away = 1.0f - v_dot_h;
    const float away_2 = away * away;
    return f0 + (glm::vec3(1.0f) - f0) * (away_2 * away_2 * away);
}

float ggx(float n_dot_h, float roughness) {
    const float a = roughness * roughness;
    const float bracket = 1.0f + n_dot_h * n_dot_h * (a * a - 1.0f);
    const float below = kPi * bracket * bracket;
    return a * a / below;
}

float geometry(float n_dot_l, float n_dot_v, float roughness) {
    const float wider = roughness + 1.0f;
    const float k = 0.125f * wider * wider;
    return one_side(n_dot_l, k) * one_side(n_dot_v, k);
}

glm::vec3 cook_torrance(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const Material& m) {
    const float nl = glm::dot(n, l), nv = cosine_of(n, v, 0.0001f);
    if (!(nl > 0.0f)) return glm::vec3(0.0f);
    const glm::vec3 h = glm::normalize(v + l);
    const float nh = cosine_of(n, h, 0.0f), vh = cosine_of(v, h, 0.0f);
    const glm::vec3 fresnel = schlick(base_reflectivity(m.albedo, m.metallic), vh);
    const float facets = ggx(nh, m.roughness) * geometry(nl, nv, m.roughness);
    const glm::vec3 mirror = fresnel * (facets / (4.0f * nl * nv));
    const glm::vec3 rest = (glm::vec3(1.0f) - fresnel) * (1.0f - m.metallic);
    const glm::vec3 matt = rest * m.albedo * (1.0f / kPi);
    return nl * (matt + mirror);
}

glm::vec3 shade(const glm::vec3& p, const glm::vec3& n, const glm::vec3& eye, const Material& m,
                const std::vector<Light>& lights) {
    const glm::vec3 normal = n / glm::length(n);
    const glm::vec3 to_eye = glm::normalize(eye - p);
    glm::vec3 total(0.0f);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        total += cook_torrance(normal, lights[i].l, to_eye, m) * lights[i].radiance;
    }
    return total;
}
