// A3 by a third hand: a switch over the kinds of light, helpers for clamping, early returns, sums term by term.
#include "assignment.hpp"

namespace {

float positive(float x) {
    return std::fmax(x, 0.0f);
}

float between_0_and_1(float x) {
    return std::fmin(std::fmax(x, 0.0f), 1.0f);
}

}  // namespace

float attenuate(const Attenuation& a, float d) {
    float below = a.constant;
    below += d * (a.linear + d * a.quadratic);
    return 1.0f / below;
}

float spot_cone(float cos_angle, float cos_inner, float cos_outer) {
    const float width = cos_inner - cos_outer;
    const float s = between_0_and_1((cos_angle - cos_outer) / width);
    return 3.0f * s * s - 2.0f * s * s * s;
}

LightSample sample_light(const Light& light, const glm::vec3& p) {
    LightSample result;
    const glm::vec3 way = light.position - p;
    const float distance = std::sqrt(glm::dot(way, way));
    switch (light.type) {
        case LightType::directional:
            result.l = -light.axis;
            result.irradiance = light.radiance;
            break;
        case LightType::point:
            result.l = way / distance;
            result.irradiance = attenuate(light.attenuation, distance) * light.radiance;
            break;
        case LightType::spot:
            result.l = way / distance;
            const float cosine = -glm::dot(result.l, light.axis);
            const float edge = spot_cone(cosine, light.cos_inner, light.cos_outer);
            result.irradiance = edge * attenuate(light.attenuation, distance) * light.radiance;
            break;
    }
    return result;
}

glm::vec3 mirror_vector(const glm::vec3& n, const glm::vec3& l) {
    const float along = glm::dot(l, n);
    const glm::vec3 foot = along * n;
    return foot + foot - l;
}

Terms phong(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const Material& m) {
    const float cos_theta = glm::dot(l, n);
    if (cos_theta <= 0.0f) return {glm::vec3(0.0f), glm::vec3(0.0f)};
    const float towards_eye = positive(glm::dot(mirror_vector(n, l), v));
    const float highlight = towards_eye > 0.0f ? std::pow(towards_eye, m.shininess) : 0.0f;
    return {cos_theta * m.diffuse, highlight * m.specular};
}

glm::vec3 shade(const SurfacePoint& point, const std::vector<Light>& lights) {
    const Material& material = point.material;
    const glm::vec3 normal = point.normal / glm::length(point.normal);
    const glm::vec3 sight = point.eye - point.position;
    const glm::vec3 eye_way = sight / glm::length(sight);
    glm::vec3 color = material.emission;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const LightSample arriving = sample_light(lights[i], point.position);
        const Terms terms = phong(normal, arriving.l, eye_way, material);
        color += arriving.irradiance * terms.diffuse;
        color += arriving.irradiance * terms.specular;
    }
    color += point.ambient_light * material.ambient;
    return color;
}
