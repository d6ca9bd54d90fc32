// A6 by a third hand: powers as products, lambdas, a structure of cosines, component by component.
#include "assignment.hpp"

namespace {

struct Cosines {
    float n_l, n_v, n_h, v_h;
};

Cosines cosines_of(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v) {
    const glm::vec3 both = l + v;
    const glm::vec3 h = both / glm::length(both);
    Cosines c;
    c.n_l = glm::dot(n, l);
    c.n_v = std::fmax(glm::dot(n, v), 0.0001f);
    c.n_h = std::fmax(glm::dot(n, h), 0.0f);
    c.v_h = std::fmax(glm::dot(v, h), 0.0f);
    return c;
}

}  // namespace

glm::vec3 base_reflectivity(const glm::vec3& albedo, float metallic) {
    const glm::vec3 dielectric(0.04f);
    return dielectric + metallic * (albedo - dielectric);
}

glm::vec3 schlick(const glm::vec3& f0, float v_dot_h) {
    const float x = 1.0f - v_dot_h;
    const float x2 = x * x;
    const float rest = x2 * x2 * x;
    glm::vec3 f;
    for (int i = 0; i < 3; ++i) f[i] = rest + f0[i] * (1.0f - rest);
    return f;
}

float ggx(float n_dot_h, float roughness) {
    const float a = roughness * roughness;
    const float a_squared = a * a;
    const float bracket = 1.0f - n_dot_h * n_dot_h * (1.0f - a_squared);
    return a_squared / kPi / (bracket * bracket);
}

float geometry(float n_dot_l, float n_dot_v, float roughness) {
    const float r = 1.0f + roughness;
    const float k = 0.125f * r * r;
    const auto one_way = [k](float cosine) { return cosine / (k + cosine - cosine * k); };
    return one_way(n_dot_v) * one_way(n_dot_l);
}

glm::vec3 cook_torrance(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const Material& m) {
    const Cosines c = cosines_of(n, l, v);
    if (!(c.n_l > 0.0f)) return glm::vec3(0.0f);
    const glm::vec3 f = schlick(base_reflectivity(m.albedo, m.metallic), c.v_h);
    const float facets = ggx(c.n_h, m.roughness) * geometry(c.n_l, c.n_v, m.roughness);
    const float below = 4.0f * c.n_v * c.n_l;
    glm::vec3 reflected;
    for (int i = 0; i < 3; ++i) {
        const float scattered = (1.0f - f[i]) * (1.0f - m.metallic) * m.albedo[i] / kPi;
        const float mirrored = facets * f[i] / below;
        reflected[i] = c.n_l * (scattered + mirrored);
    }
    return reflected;
}

glm::vec3 shade(const glm::vec3& p, const glm::vec3& n, const glm::vec3& eye, const Material& m,
                const std::vector<Light>& lights) {
    const glm::vec3 up = n / std::sqrt(glm::dot(n, n));
    const glm::vec3 to_eye = glm::normalize(eye - p);
    glm::vec3 total(0.0f);
    for (std::size_t i = 0; i != lights.size(); ++i) {
        const glm::vec3 reflected = cook_torrance(up, lights[i].l, to_eye, m);
        total += reflected * lights[i].radiance;
    }
    return total;
}
