// A3, solved by another hand: switches, channels in loops, cosines kept in a struct.
#include "assignment.hpp"

namespace {

struct Cosines {
    float diffuse, mirror;
};

float squared(float x) {
    return x * x;
}

float ramp(float low, float high, float x) {
    if (x <= low) return 0.0f;
    if (x >= high) return 1.0f;
    return (x - low) / (high - low);
}

Cosines cosines_of(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v) {
    const float n_l = n.x * l.x + n.y * l.y + n.z * l.z;
    if (n_l <= 0.0f) return {0.0f, 0.0f};
    const float r_v = glm::dot(mirror_vector(n, l), v);
    return {n_l, r_v > 0.0f ? r_v : 0.0f};
}

}  // namespace

float attenuate(const Attenuation& a, float d) {
    float sum = a.constant;
    sum += a.linear * d;
    sum += a.quadratic * squared(d);
    return 1.0f / sum;
}

float spot_cone(float cos_angle, float cos_inner, float cos_outer) {
    const float t = ramp(cos_outer, cos_inner, cos_angle);
    return squared(t) * 3.0f - squared(t) * t * 2.0f;
}

LightSample sample_light(const Light& light, const glm::vec3& p) {
    switch (light.type) {
        case LightType::directional: return {-1.0f * light.axis, light.radiance};
        case LightType::point:
        case LightType::spot: break;
    }
    const glm::vec3 ray = p - light.position;
    const float d2 = glm::dot(ray, ray);
    const glm::vec3 along = ray / std::sqrt(d2);
    float strength = attenuate(light.attenuation, std::sqrt(d2));
    if (light.type == LightType::spot) {
        strength *= spot_cone(glm::dot(along, light.axis), light.cos_inner, light.cos_outer);
    }
    return {-along, strength * light.radiance};
}

glm::vec3 mirror_vector(const glm::vec3& n, const glm::vec3& l) {
    const float twice = 2.0f * (n.x * l.x + n.y * l.y + n.z * l.z);
    return glm::vec3(twice * n.x - l.x, twice * n.y - l.y, twice * n.z - l.z);
}

Terms phong(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const Material& m) {
    const Cosines c = cosines_of(n, l, v);
    const float gloss = c.mirror > 0.0f ? std::exp(m.shininess * std::log(c.mirror)) : 0.0f;
    return {c.diffuse * m.diffuse, gloss * m.specular};
}

glm::vec3 shade(const SurfacePoint& point, const std::vector<Light>& lights) {
    const glm::vec3 n = point.normal / glm::length(point.normal);
    const glm::vec3 way = point.eye - point.position;
    const glm::vec3 v = way / glm::length(way);
    glm::vec3 reflected(0.0f);
    for (const Light& light : lights) {
        const LightSample sample = sample_light(light, point.position);
        const Terms terms = phong(n, sample.l, v, point.material);
        for (int i = 0; i < 3; ++i) reflected[i] += sample.irradiance[i] * (terms.diffuse[i] + terms.specular[i]);
    }
    return point.material.emission + point.material.ambient * point.ambient_light + reflected;
}
