// A3, solved by another hand: helpers, Horner's rule, early returns.
#include "assignment.hpp"

namespace {

float between_0_and_1(float x) {
    return std::fmin(std::fmax(x, 0.0f), 1.0f);
}

glm::vec3 unit(const glm::vec3& a) {
    return a / std::sqrt(glm::dot(a, a));
}

}  // namespace

float attenuate(const Attenuation& a, float d) {
    const float falloff = (a.quadratic * d + a.linear) * d + a.constant;
    return 1.0f / falloff;
}

float spot_cone(float cos_angle, float cos_inner, float cos_outer) {
    const float t = between_0_and_1((cos_angle - cos_outer) / (cos_inner - cos_outer));
    return 3.0f * t * t - 2.0f * t * t * t;
}

LightSample sample_light(const Light& light, const glm::vec3& p) {
    LightSample answer{-light.axis, light.radiance};
    if (light.type == LightType::directional) return answer;
    const glm::vec3 way = light.position - p;
    answer.l = unit(way);
    answer.irradiance *= attenuate(light.attenuation, glm::length(way));
    if (light.type == LightType::point) return answer;
    const float cosine = -glm::dot(answer.l, light.axis);
    answer.irradiance *= spot_cone(cosine, light.cos_inner, light.cos_outer);
    return answer;
}

glm::vec3 mirror_vector(const glm::vec3& n, const glm::vec3& l) {
    const glm::vec3 foot = glm::dot(l, n) * n;
    return foot + (foot - l);
}

Terms phong(const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, const Material& m) {
    Terms answer{glm::vec3(0.0f), glm::vec3(0.0f)};
    const float facing = glm::dot(l, n);
    if (facing <= 0.0f) return answer;
    answer.diffuse = facing * m.diffuse;
    const float shine = glm::dot(mirror_vector(n, l), v);
    if (shine > 0.0f) answer.specular = std::pow(shine, m.shininess) * m.specular;
    return answer;
}

glm::vec3 shade(const SurfacePoint& point, const std::vector<Light>& lights) {
    const Material& m = point.material;
    const glm::vec3 n = unit(point.normal);
    const glm::vec3 to_eye = unit(point.eye - point.position);
    glm::vec3 color = m.emission;
    color += m.ambient * point.ambient_light;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const LightSample in = sample_light(lights[i], point.position);
        const Terms out = phong(n, in.l, to_eye, m);
        color += in.irradiance * out.diffuse;
        color += in.irradiance * out.specular;
    }
    return color;
}
