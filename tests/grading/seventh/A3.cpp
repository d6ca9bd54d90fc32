// A3, by one who likes small helpers and leaves a function early.
#include "assignment.hpp"

namespace {

float saturate(float x) {
    return std::fmin(std::fmax(x, 0.0f), 1.0f);
}

glm::vec3 unit(const glm::vec3& a) {
    return a / std::sqrt(glm::dot(a, a));
}

}  // namespace

float attenuate(const Attenuation& a, float d) {
    return 1.0f / (a.constant + d * (a.linear + d * a.quadratic));
}

float spot_cone(float cos_angle, float cos_inner, float cos_outer) {
    const float t = saturate((cos_outer - cos_angle) / (cos_outer - cos_inner));
    return t * t * (1.0f + 2.0f * (1.0f - t));
}

LightSample sample_light(const Light& light, const glm::vec3& p) {
    LightSample s{light.axis * -1.0f, light.radiance};
    if (light.type == LightType::directional) return s;
    const glm::vec3 to_lamp = light.position - p;
    const float away = std::sqrt(glm::dot(to_lamp, to_lamp));
    s.l = to_lamp * (1.0f / away);
    s.irradiance *= attenuate(light.attenuation, away);
    if (light.type == LightType::point) return s;
    const float cosine = -glm::dot(s.l, light.axis);
    s.irradiance *= spot_cone(cosine, light.cos_inner, light.cos_outer);
    return s;
}

glm::vec3 mirror_vector(const glm::vec3& n, const glm::vec3& l) {
    const glm::vec3 along = glm::dot(l, n) * n;
    return along + (along - l);
}

Terms phong(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const Material& m) {
    const float facing = glm::dot(n, l);
    if (facing <= 0.0f) return {glm::vec3(0.0f), glm::vec3(0.0f)};
    const float aim = std::fmax(glm::dot(mirror_vector(n, l), v), 0.0f);
    return {facing * m.diffuse, std::pow(aim, m.shininess) * m.specular};
}

glm::vec3 shade(const SurfacePoint& point, const std::vector<Light>& lights) {
    const glm::vec3 n = unit(point.normal);
    const glm::vec3 v = unit(point.eye - point.position);
    const glm::vec3 ambient = point.material.ambient * point.ambient_light;
    glm::vec3 lit(0.0f);
    for (const Light& lamp : lights) {
        const LightSample arriving = sample_light(lamp, point.position);
        const Terms terms = phong(n, arriving.l, v, point.material);
        lit += terms.diffuse * arriving.irradiance;
        lit += terms.specular * arriving.irradiance;
    }
    return lit + ambient + point.material.emission;
}
