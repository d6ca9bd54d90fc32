// A6, solved by another hand: products in steps, the visibility term in place of G over its denominator's factors.
#include "assignment.hpp"

namespace {

float cosine(const glm::vec3& a, const glm::vec3& b) {
    const float c = a.x * b.x + a.y * b.y + a.z * b.z;
    return c < 0.0f ? 0.0f : c;
}

float one_side(float c, float k) {
    return c / (c - c * k + k);
}

}  // namespace

glm::vec3 base_reflectivity(const glm::vec3& albedo, float metallic) {
    const glm::vec3 dielectric(0.04f);
    return dielectric + metallic * (albedo - dielectric);
}

glm::vec3 schlick(const glm::vec3& f0, float v_dot_h) {
    const float m = 1.0f - v_dot_h;
    const float m5 = m * m * m * m * m;
    return f0 * (1.0f - m5) + glm::vec3(m5);
}

float ggx(float n_dot_h, float roughness) {
    const float a = roughness * roughness;
    const float c2 = n_dot_h * n_dot_h;
    const float bracket = c2 * a * a + (1.0f - c2);
    const float ratio = a / bracket;
    return ratio * ratio / kPi;
}

float geometry(float n_dot_l, float n_dot_v, float roughness) {
    const float r1 = 1.0f + roughness;
    const float k = 0.125f * r1 * r1;
    return one_side(n_dot_v, k) * one_side(n_dot_l, k);
}

glm::vec3 cook_torrance(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const Material& m) {
    if (glm::dot(n, l) <= 0.0f) return glm::vec3(0.0f);
    const float nl = cosine(n, l);
    const float nv = std::fmax(cosine(n, v), 1e-4f);
    const glm::vec3 sum = l + v;
    const glm::vec3 h = sum / std::sqrt(glm::dot(sum, sum));
    const glm::vec3 f = schlick(base_reflectivity(m.albedo, m.metallic), cosine(h, v));
    const float d = ggx(cosine(h, n), m.roughness);
    const float g = geometry(nl, nv, m.roughness);
    glm::vec3 mirrored = f;
    mirrored *= d * g;
    mirrored /= 4.0f * nl * nv;
    glm::vec3 scattered = m.albedo / kPi;
    scattered *= 1.0f - f;
    scattered *= 1.0f - m.metallic;
    return nl * (mirrored + scattered);
}

glm::vec3 shade(const glm::vec3& p, const glm::vec3& n, const glm::vec3& eye, const Material& m,
                const std::vector<Light>& lights) {
    const glm::vec3 normal = n / std::sqrt(glm::dot(n, n));
    const glm::vec3 to_eye = (eye - p) / glm::length(eye - p);
    glm::vec3 color(0.0f);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const glm::vec3 f = cook_torrance(normal, lights[i].l, to_eye, m);
        color += f * lights[i].radiance;
    }
    return color;
}
