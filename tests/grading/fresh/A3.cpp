// A3, solved by another hand: a switch, standard functions, one statement a step.
#include "assignment.hpp"

#include <algorithm>

float attenuate(const Attenuation& a, float d) {
    const float d2 = d * d;
    float denominator = a.constant;
    denominator += a.linear * d;
    denominator += a.quadratic * d2;
    return 1.0f / denominator;
}

float spot_cone(float cos_angle, float cos_inner, float cos_outer) {
    if (cos_angle >= cos_inner) return 1.0f;
    if (cos_angle <= cos_outer) return 0.0f;
    const float x = (cos_angle - cos_outer) / (cos_inner - cos_outer);
    return 3.0f * x * x - 2.0f * x * x * x;
}

LightSample sample_light(const Light& light, const glm::vec3& p) {
    LightSample out;
    switch (light.type) {
        case LightType::directional:
            out.l = glm::vec3(-light.axis.x, -light.axis.y, -light.axis.z);
            out.irradiance = light.radiance;
            break;
        case LightType::point:
            out.l = glm::normalize(light.position - p);
            out.irradiance = light.radiance * attenuate(light.attenuation, glm::distance(p, light.position));
            break;
        case LightType::spot:
            out.l = glm::normalize(light.position - p);
            out.irradiance = light.radiance * attenuate(light.attenuation, glm::distance(p, light.position));
            out.irradiance *=
                spot_cone(glm::dot(glm::normalize(p - light.position), light.axis), light.cos_inner, light.cos_outer);
            break;
    }
    return out;
}

glm::vec3 mirror_vector(const glm::vec3& n, const glm::vec3& l) {
    return -glm::reflect(l, n);
}

Terms phong(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const Material& m) {
    const float lambert = std::max(glm::dot(l, n), 0.0f);
    Terms result;
    result.diffuse = lambert * m.diffuse;
    result.specular = glm::vec3(0.0f);
    if (lambert > 0.0f) {
        const float c = std::max(glm::dot(mirror_vector(n, l), v), 0.0f);
        result.specular = std::pow(c, m.shininess) * m.specular;
    }
    return result;
}

glm::vec3 shade(const SurfacePoint& point, const std::vector<Light>& lights) {
    const glm::vec3 normal = point.normal / glm::length(point.normal);
    const glm::vec3 to_eye = (point.eye - point.position) / glm::length(point.eye - point.position);
    glm::vec3 color = point.material.emission;
    color += point.material.ambient * point.ambient_light;
    for (std::size_t i = 0; i < lights.size(); i++) {
        const LightSample incoming = sample_light(lights[i], point.position);
        const Terms terms = phong(normal, incoming.l, to_eye, point.material);
        color += terms.diffuse * incoming.irradiance;
        color += terms.specular * incoming.irradiance;
    }
    return color;
}
