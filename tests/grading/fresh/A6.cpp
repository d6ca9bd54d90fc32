// A6, solved by another hand: short names as in papers, helpers, early returns.
#include "assignment.hpp"

namespace {

float sq(float x) {
    return x * x;
}

float g1(float cosine, float k) {
    return cosine / (cosine * (1.0f - k) + k);
}

}  // namespace

glm::vec3 base_reflectivity(const glm::vec3& albedo, float metallic) {
    return glm::mix(glm::vec3(0.04f), albedo, metallic);
}

glm::vec3 schlick(const glm::vec3& f0, float v_dot_h) {
    const float m = 1.0f - v_dot_h;
    const float m5 = m * m * m * m * m;
    return f0 * (1.0f - m5) + glm::vec3(m5);
}

float ggx(float n_dot_h, float roughness) {
    const float a2 = sq(sq(roughness));
    const float d = sq(n_dot_h) * (a2 - 1.0f) + 1.0f;
    return a2 / (kPi * sq(d));
}

float geometry(float n_dot_l, float n_dot_v, float roughness) {
    const float k = sq(roughness + 1.0f) * 0.125f;
    return g1(n_dot_l, k) * g1(n_dot_v, k);
}

glm::vec3 cook_torrance(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const Material& m) {
    const float nl = glm::dot(n, l);
    if (!(nl > 0.0f)) return {0.0f, 0.0f, 0.0f};
    const float nv = std::fmax(glm::dot(n, v), 1e-4f);
    glm::vec3 h = l + v;
    h /= glm::length(h);
    const float nh = std::fmax(glm::dot(n, h), 0.0f), vh = std::fmax(glm::dot(v, h), 0.0f);
    const glm::vec3 F = schlick(base_reflectivity(m.albedo, m.metallic), vh);
    const float DG = ggx(nh, m.roughness) * geometry(nl, nv, m.roughness);
    const glm::vec3 mirrored = F * DG / (4.0f * nv);  // n.l cancels out
    const glm::vec3 scattered = (glm::vec3(1.0f) - F) * (1.0f - m.metallic) * m.albedo * (nl / kPi);
    return mirrored + scattered;
}

glm::vec3 shade(const glm::vec3& p, const glm::vec3& n, const glm::vec3& eye, const Material& m,
                const std::vector<Light>& lights) {
    glm::vec3 out{0.0f, 0.0f, 0.0f};
    const glm::vec3 N = n / glm::length(n), V = glm::normalize(eye - p);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const glm::vec3 f = cook_torrance(N, lights[i].l, V, m);
        out += f * lights[i].radiance;
    }
    return out;
}
